/// A short list of triangles that cannot lack the nearest one, so that exact arithmetic over a whole mesh is
/// fast.
#pragma once

#include <cstdint>
#include <vector>

#include "cdfr/core/types.h"
#include "cdfr/mesh/mesh.h"

namespace cdfr::oracle {

/// Borrows the mesh. Preconditions: coordinates are 0 or 2^-200 to 2^200 in size; at least one triangle.
///
/// Why the nearest triangle cannot be lost. Every triangle T has a lower bound L(T) <= d(p, T), and U is a
/// minimum of upper bounds, so U >= the least distance; T leaves only if L(T) > U + slack. Bounds, all of
/// them true of any triangle however badly it is shaped:
/// - lower: distance to the centre of a sphere around T less its radius, by the triangle inequality;
/// - lower: the least of u . (v - p) over the corners v, for a unit vector u: a half-space holds T. Any u
/// will do, so u
///   may come from a careless closest point; a poor one makes the list longer, never wrong;
/// - upper: the distance to any point of T, which is what the careless closest point is: a convex combination
/// of corners. Rounding: each bound takes fewer than 40 operations on numbers no larger than 4 M, M being the
/// largest absolute coordinate of p and the mesh, none of them divided by a small number but in the choice of
/// u and of the combination, where errors are harmless. So a bound is off by less than 2^9 * 2^-53 * M; the
/// slack is 2^-40 M, sixteen times that. A bound that overflowed to infinity or NaN keeps its triangle.
class Candidates {
 public:
  explicit Candidates(MeshView mesh);
  /// Ascending numbers of triangles, among them every one at the least exact distance from p.
  std::vector<std::uint32_t> near(Vec3 p) const;

 private:
  struct Sphere {
    Vec3 centre;
    double radius = 0;
  };
  MeshView mesh_;
  std::vector<Sphere> spheres_;
  double largest_ = 0;  ///< absolute coordinate
};

}  // namespace cdfr::oracle
