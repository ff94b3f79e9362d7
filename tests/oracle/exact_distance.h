/// The truth that the library's distances are held to: point-triangle distance in exact arithmetic.
///
/// Shares no code and no formula with the library: integers of any length, no rounding before the last step,
/// no tolerance anywhere. Coordinates may be any finite doubles; triangles may have no area, be segments or
/// be points.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "cdfr/core/types.h"
#include "cdfr/mesh/mesh.h"
#include "oracle/exact_number.h"

namespace cdfr::oracle {

/// Squared distance and closest point as exact ratios.
struct Exact {
  Ratio squared;
  std::array<Ratio, 3> foot;  ///< the closest point; unique, a triangle being convex

  /// To more than 150 bits.
  Ratio distance() const { return square_root(squared); }
  /// |computed - distance| in ulps at the largest absolute coordinate of the query p and the mesh.
  double error_in_ulps(double computed, Vec3 p, double mesh_max_abs) const;
  /// Largest |coordinate of computed - coordinate of foot| in the same unit.
  double foot_error_in_ulps(Vec3 computed, Vec3 p, double mesh_max_abs) const;
};

/// Precondition: all coordinates are finite.
Exact exact_distance(Vec3 p, Vec3 a, Vec3 b, Vec3 c);

/// Strictly nearer, decided exactly.
bool exact_less(const Exact& a, const Exact& b);

/// The nearest of some triangles; the lowest number among those that are exactly equally near.
struct ExactClosest {
  Exact exact;
  std::uint32_t triangle = no_index;
};

/// Looks at every candidate: see candidates.h for a list that is short and cannot lack the nearest one.
/// Precondition: at least one candidate.
ExactClosest exact_closest(MeshView mesh, Vec3 p, std::span<const std::uint32_t> candidates);

}  // namespace cdfr::oracle
