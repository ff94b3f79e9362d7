/// Does a triangle touch a box?
#pragma once

#include <array>

#include "cdfr/core/types.h"

namespace cdfr {

/// False only if the triangle certainly misses the closed box: a separating axis exists by more than
/// rounding. Akenine-Moller, "Fast 3D triangle-box overlap testing", 2001, with a bound on each comparison.
bool may_touch(const std::array<Vec3, 3>& triangle, const Box& box) noexcept;

}  // namespace cdfr
