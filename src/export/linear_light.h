/// What glTF wants of colours: amounts of light, where screens and PLY files have sRGB.
#pragma once

#include <array>

namespace cdfr {

/// The light of each of the 256 sRGB levels, 0 to 1 (IEC 61966-2-1).
std::array<float, 256> linear_light() noexcept;

}  // namespace cdfr
