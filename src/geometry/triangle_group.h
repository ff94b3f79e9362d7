/// Eight triangles side by side, and a fast estimate of their squared distances that only prunes:
/// double-double answers.
#pragma once

#include <array>
#include <cstddef>

#include "cdfr/core/types.h"
#include "geometry/double_double.h"

namespace cdfr {

inline constexpr std::size_t group_size = 8;

/// Structure of arrays. Lanes beyond the last triangle repeat it.
struct alignas(64) TriangleGroup {
  double vertices[3][3][group_size];  ///< [corner][axis][lane]
  double normals[3][group_size];      ///< unit, or zero where the area is zero; [axis][lane]

  Vec3 vertex(std::size_t corner, std::size_t lane) const noexcept {
    return {vertices[corner][0][lane], vertices[corner][1][lane], vertices[corner][2][lane]};
  }
  Vec3 normal(std::size_t lane) const noexcept {
    return {normals[0][lane], normals[1][lane], normals[2][lane]};
  }
};

/// |estimated distance - distance| <= estimate_error * R, where R bounds the distance from p to every vertex.
///
/// With u = 2^-53: the three clamped segments are off by less than 26u R (point_triangle.cpp,
/// estimated_edge_distance). The face counts only where the projection is inside by more than the rounding of
/// the test, 16u |e|_1 |r|_1; there the height is off by less than 6u R. Where a projection is inside by
/// less, the segments answer, too large by at most that length: (16 + 8)u * 3 R. In all 98u R; the constant
/// is 128u. It holds at any aspect ratio.
inline constexpr double estimate_error = 128 * unit_roundoff;

using GroupDistances = std::array<double, group_size>;

/// Squared distance estimates from p to the eight triangles.
void estimate_squared(const Vec3& p, const TriangleGroup& group, GroupDistances& squared) noexcept;

/// The closest point of one triangle to p, by the same arithmetic: within estimate_error * R of the triangle,
/// and no farther from p than the closest one by more than that.
Vec3 estimate_closest(const Vec3& p, const TriangleGroup& group, std::size_t lane) noexcept;

}  // namespace cdfr
