/// THE distance kernel: from a point to a triangle, to half an ulp of the distance itself (promise 1).
///
/// A pure function of the bits of the point and the triangle, and independent of the order of the vertices:
/// octree, BVH and brute force share it, and the two triangles of an edge give identical bits when the edge
/// is closest.
///
/// Derivation. Let R be the largest distance from p to a vertex. Differences p - v and v - v' are exact in
/// double-double. A dot product of those has an error below 24u^2 of the product of lengths (7u^2 a product,
/// 3u^2 a sum, three terms), so with |e| <= 2R:
///  - vertex: relative error of the squared distance below 20u^2;
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
#include <cstdint>

#include "cdfr/core/types.h"
#include "geometry/double_double.h"

namespace cdfr {

/// A triangle as the kernel wants it. The normal is unit_normal's; zero for a triangle of no area, whose
/// edges answer.
struct TriangleShape {
  std::array<Vec3, 3> vertices;
  DoubleDouble3 normal;
};

/// Where on the triangle the closest point lies: 0 the face; 1 + k edge k, from corner k to (k + 1) % 3; 4 +
/// k corner k.
using TrianglePlace = std::uint8_t;

struct Foot {
  DoubleDouble squared;  ///< squared distance
  DoubleDouble3 offset;  ///< p minus the closest point
  DoubleDouble along;    ///< on an edge: parameter from the edge's corner k, in (0, 1)
  TrianglePlace place = 0;
};

/// Preconditions: coordinates in the range of query_range.h. No allocation; about 50 ns on a face, 250 ns on
/// an edge.
Foot measure(const Vec3& p, const TriangleShape& triangle) noexcept;

/// Barycentric coordinates of the foot: they are 0 or more and add up to 1 but for rounding.
std::array<double, 3> barycentric(const Vec3& p, const TriangleShape& triangle, const Foot& foot) noexcept;

}  // namespace cdfr
