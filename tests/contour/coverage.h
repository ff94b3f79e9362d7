/// Points of a true contour, found by brute force alone, and the search for a hole between the extracted
/// ones.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "cdfr/core/types.h"
#include "contour/case.h"

namespace cdfr::test {

/// Up to `count` random points of the contour at that distance: a point of the box farther from the surface,
/// on the contour's side, is moved toward its foot, which stays its foot, until the height is right.
std::vector<Vec3> true_contour(const Case& part, double distance, const Box& box, std::size_t count,
                               std::uint64_t seed);

/// Points on the twelve edges of a box.
std::vector<Vec3> points_on_edges(const Box& box, std::size_t count, std::uint64_t seed);

/// Fails if one of the true points has no extracted point within the tolerance.
void expect_covered(const Contour& contour, std::span<const Vec3> true_points);

/// Fails as well if brute force says that they are not on the contour.
void expect_contour_covers(const Case& part, const Contour& contour, std::span<const Vec3> true_points);

}  // namespace cdfr::test
