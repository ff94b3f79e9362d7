/// The generalised winding number: how often a mesh, open or closed, winds around a point.
///
/// w(p) = sum of the triangles' solid angles / 4 pi (Jacobson, Kavan, Sorkine-Hornung, "Robust inside-outside
/// segmentation using generalized winding numbers", 2013). Far nodes of the BVH answer as a whole by their
/// first two moments (Barill, Dickson, Schmidt, Levin, Jacobson, "Fast winding numbers for soups and clouds",
/// 2018), here with a bound on what they leave out, so that a sum is refined until it says on which side of
/// 1/2 it is, down to single triangles.
///
/// **The bound.** A triangle's angle is the integral of n . g(h), g = grad of -1/|r + h|, over its points
/// centre + h, r from p to the centre, d = |r|. The k-th term of g's expansion in h is the gradient of a
/// zonal solid harmonic of degree k + 1 over d^(k+2), and is at most (k + 1)|h|^k / d^(k+2) (Bernstein's and
/// Szego's inequality for Legendre polynomials). Kept are k = 0 and 1. With |h| <= R, q = R/d < 1 and the
/// spread S = the integral of |h|^2, the rest is at most S/R^2 / d^2 * sum over k >= 2 of (k + 1) q^k = S (3
/// - 2 q) / (d^4 (1 - q)^2).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "cdfr/core/types.h"
#include "cdfr/octree/leaf.h"
#include "core/array.h"
#include "core/scratch.h"
#include "field/boundary.h"
#include "geometry/solid_angle.h"
#include "mesh/bvh.h"

namespace cdfr {

/// Moments of all triangles below a BVH node.
struct WindingMoments {
  Vec3 centre;                    ///< of area
  Vec3 area;                      ///< integral of the normal
  std::array<double, 6> first{};  ///< symmetric part of the integral of n h^T: xx, yy, zz, xy, yz, zx
  double total = 0;               ///< area, rounded up
  double doubt = 0;               ///< bound on the error of `area`: of needles it is far larger than they are
  double spread = 0;              ///< integral of |h|^2, rounded up
  double radius = 0;              ///< no |h| is larger
};

/// Empty for a mesh that needs none.
struct WindingTree {
  Array<WindingMoments> nodes;  ///< one a BVH node
  Boundary boundary;

  bool empty() const noexcept { return nodes.empty(); }
};

/// Edge ids of the records are below edge_count. O(n).
WindingTree build_winding_tree(SearchSpace space, std::size_t edge_count, const Scratch* scratch = nullptr);

/// w(p), nodes taken whole where p is at least `opening` of their radii away; infinite: triangle by triangle.
Bounded winding_number(const WindingTree& tree, SearchSpace space, const Vec3& p, double opening) noexcept;

/// w(p) as a whole number and a sum over the boundary: with a fan of triangles from each boundary edge to the
/// point at infinity behind p the mesh is closed, a ray from p straight ahead crosses none of the fan, so the
/// crossings of the mesh count the windings of both together, and what the fan takes up is subtracted. Exact
/// but for rounding. O(boundary) and one ray.
Bounded winding_by_boundary(const WindingTree& tree, SearchSpace space, const Vec3& p) noexcept;

/// w(p), as a rule to within that error.
Bounded winding_within(const WindingTree& tree, SearchSpace space, const Vec3& p, double error) noexcept;

/// w(p) > 1/2, refined until certain or exact but for rounding; within 2^-80 of a boundary edge's length from
/// it w is not known to better than a whole turn of that edge, and any side may come back.
bool winds(const WindingTree& tree, SearchSpace space, const Vec3& p) noexcept;

/// The side of all points that a straight way of at most `radius` without triangles joins to the centre:
/// certain if |w(centre) - 1/2| exceeds what the boundary can change (boundary.h), else undecided.
Side side_of_ball(const WindingTree& tree, SearchSpace space, const Vec3& centre, double radius) noexcept;

}  // namespace cdfr
