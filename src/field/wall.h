/// Two triangles of a flat wall, taken as one plane where a box's projection stays on them.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "cdfr/core/types.h"
#include "geometry/point_triangle.h"

namespace cdfr {

/// If the triangles share an edge, lie in one plane exactly, and hold the orthogonal projections of all the
/// corners' hull, then the distance from any point of the hull to the surface is at most its height above the
/// plane: a convex function, without the seam that each triangle's own distance has beyond the edge. The
/// heights of the corners, or nothing.
///
/// The hull's projection is covered by a rectangle along the shared edge; its half on either side of the edge
/// has to lie in that side's triangle, which its four corners tell. The test is in double with no slack: a
/// projection that rounds into a triangle from outside is off by less than 64u of the box's distance, which
/// the caller's rounding covers.
std::optional<std::array<double, 8>> wall_heights(const TriangleShape& a, const TriangleShape& b,
                                                  std::span<const Vec3, 8> corners) noexcept;

}  // namespace cdfr
