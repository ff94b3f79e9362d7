/// THE distance kernel: from a point to a triangle, to half an ulp of the distance itself (promise 1).
///
/// A pure function of the bits of the point and the triangle, and independent of the order of the vertices:
/// octree, BVH and brute force share it, and the two triangles of an edge give identical bits when the edge
/// is closest.
///
/// Derivation. Let R be the largest distance from p to a vertex. Differences p - v and v - v' are exact in
/// double-double. A dot product of those has an error below 24u^2 of the product of lengths
/// (double_double.h), so with |e| <= 2R:
///  - vertex: relative error of the squared distance below 24u^2;
///  - edge: the parameter t is off by less than 2^-98 R/|e|, the perpendicular p - v - t e by less than 2^-97
///  R;
///  - face: the normal is good to 2^-98 (unit_normal.h), the height to 2^-96 R.
/// A face counts only where the projection is inside all three edges by more than the bound of the test
/// itself, 2^-94 R in length. Elsewhere the edges answer: if the projection is inside after all, it is within
/// that length of an edge, so the distance is too large by at most that. (Accepting doubtful projections
/// would be wrong: past the tip of a needle a point is within rounding of both edge lines and far from the
/// triangle.) So the distance is within 2^-93 R of the truth before it is rounded, at any aspect ratio; the
/// rounded square root is within (1/2 + 2^-50) ulp of that. Since d <= 2 sqrt(3) M for the largest absolute
/// coordinate M, ulp(d) is at most 4 ulp(M), and the total is below 2 ulp(M) + 2^-90 ulp(M): the promise
/// is 4.
#pragma once

#include <array>

#include "cdfr/core/types.h"
#include "geometry/double_double.h"
#include "geometry/place_estimate.h"

namespace cdfr {

/// A triangle as the kernel wants it. The normal is unit_normal's; zero for a triangle of no area, whose
/// edges answer.
struct TriangleShape {
  std::array<Vec3, 3> vertices;
  DoubleDouble3 normal;
};

/// Share of |p - v|_1 below which a height or an edge distance may be rounding alone: above the 2^-96 R of
/// the derivation.
inline constexpr double negligible_height = 0x1p-94;

/// On an edge or a corner all triangles that touch it give the same bits but for `place`.
struct Foot {
  DoubleDouble squared;  ///< squared distance
  DoubleDouble3 offset;  ///< p minus the closest point
  DoubleDouble along;    ///< on the face: height by the normal; on an edge: parameter in (0, 1) from
                         ///< the end that comes first by coordinates
  TrianglePlace place = 0;
};

/// Preconditions: coordinates in the range of query_range.h. No allocation; about 40 ns on a face, 100 ns on
/// an edge, 50 ns at a corner.
Foot measure(const Vec3& p, const TriangleShape& triangle) noexcept;

/// The same, by what estimate_place said of the two.
Foot measure(const Vec3& p, const TriangleShape& triangle, const PlaceEstimate& estimate) noexcept;

/// Barycentric coordinates of the foot: they are 0 or more and add up to 1 but for rounding.
std::array<double, 3> barycentric(const Vec3& p, const TriangleShape& triangle, const Foot& foot) noexcept;

}  // namespace cdfr
