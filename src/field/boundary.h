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
#include <optional>
#include <vector>

#include "cdfr/core/types.h"
#include "core/array.h"
#include "core/scratch.h"
#include "mesh/bvh.h"

namespace cdfr {

/// In the direction that is run along more often.
struct BoundaryEdge {
  Vec3 from, to;
  double times = 0;  ///< how often it counts
};

struct Boundary {
  Array<BoundaryEdge> edges;   ///< each once, in the order of slots
  Array<std::uint32_t> first;  ///< by group: its first edge; one more at the end
  Array<double> lengths;       ///< by BVH node, rounded up
};

/// Edge ids of the records are below edge_count. O(n).
Boundary find_boundary(SearchSpace space, std::size_t edge_count, const Scratch* scratch = nullptr);

/// Bound on |w(x) - w(centre)| for such x; infinite if the boundary comes that near or nearly so.
double winding_drift(const Boundary& boundary, SearchSpace space, const Vec3& centre, double radius) noexcept;

/// How w changes in a ball around a centre, but for crossings: by what the near edges sweep (AngleSum), by
/// the gradient that the others have at the centre, and by no more than the drift beside.
///
/// The others' second derivative is at most 2 L / (4 pi r^3) for each, so what a way of R leaves beside their
/// gradient is R^2 L / (4 pi (r - R)^3); of far nodes the gradient is left out and R L / (4 pi (r - R)^2)
/// counts.
struct BoundaryPart {
  std::vector<std::uint32_t> near;  ///< numbers of edges, ascending
  Vec3 gradient;
  double drift = 0;
};

/// With so few near edges that the drift is no more than `budget`; nothing if that takes more than
/// `most_near`, or more than a thousand are at hand.
std::optional<BoundaryPart> boundary_around(const Boundary& boundary, SearchSpace space, const Vec3& centre,
                                            double radius, double budget, std::size_t most_near);

}  // namespace cdfr
