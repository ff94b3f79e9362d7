/// Triangulation of a polygon by cutting its ears.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "analysis/profile.h"

namespace cdfr::test {

/// Triangles of corner numbers, counter-clockwise. The polygon is simple and counter-clockwise, its corners
/// farther than 1e-9 from each other and from sides not theirs, no three in a row on a line. O(n^3) at worst.
std::vector<std::array<std::uint32_t, 3>> cut_ears(const std::vector<Point2>& polygon);

}  // namespace cdfr::test
