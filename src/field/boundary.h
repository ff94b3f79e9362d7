/// The boundary of an open mesh: the edges that its triangles run along more often one way than the other;
/// and how much the winding number can change within a ball, which hangs on the boundary alone.
///
/// Where no triangle is, w is harmonic and its gradient is the Biot-Savart field of the boundary: at most
/// L / (4 pi r^2) for boundary of length L, none nearer than r. So along any straight way from c that meets
/// no triangle and stays within R of c (in a ball or a convex cell without triangles, for one) w differs from
/// w(c) by at most R * sum of L_i / (4 pi (r_i - R)^2), r_i the distance from c to part i of the boundary.
/// Near parts are cut small, far ones taken together by BVH node.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "cdfr/core/types.h"
#include "mesh/bvh.h"

namespace cdfr {

/// In the direction that is run along more often.
struct BoundaryEdge {
  Vec3 from, to;
  double times = 0;  ///< how often it counts
};

struct Boundary {
  std::vector<BoundaryEdge> edges;   ///< each once, in the order of slots
  std::vector<std::uint32_t> first;  ///< by group: its first edge; one more at the end
  std::vector<double> lengths;       ///< by BVH node, rounded up
};

/// Edge ids of the records are below edge_count. O(n).
Boundary find_boundary(SearchSpace space, std::size_t edge_count);

/// Bound on |w(x) - w(centre)| for such x; infinite if the boundary comes that near or nearly so.
double winding_drift(const Boundary& boundary, SearchSpace space, const Vec3& centre, double radius) noexcept;

/// The boundary in two: what a winding number that is known at a centre has to be corrected by edge by edge
/// (swept_angle), and how much the rest changes it.
struct NearBoundary {
  std::vector<std::uint32_t> edges;
  double drift = 0;
};

/// So few near edges that the rest drifts by no more than `budget`, if that can be had.
NearBoundary near_boundary(const Boundary& boundary, SearchSpace space, const Vec3& centre, double radius,
                           double budget);

}  // namespace cdfr
