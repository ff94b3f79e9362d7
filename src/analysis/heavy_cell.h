/// A cube of the octree's lattice that may hold points deeper than T, and what is known of the depth in it.
#pragma once

#include <cmath>
#include <cstdint>

#include "cdfr/core/types.h"
#include "octree/lattice.h"

namespace cdfr {

/// The depth asked for, and how well.
struct Threshold {
  double depth = 0;     ///< T
  double error = 0;     ///< e: cubes of a half diagonal up to that are not halved
  double flat = 0;      ///< cubes in which the depth is known to that are not halved either
  double rounding = 0;  ///< of a distance or its bound; depths above T by no more do not count
  bool jumps = false;   ///< the sign jumps off the surface
};

/// With y from the cell's centre, the depth is above T by
///     over + gradient.y - below  at least,  and  over + gradient.y + above  at most,
/// rounding included. So {depth > T} in the cell lies between two sets that a plane cuts from the cube, both
/// convex: the sure part, where the first is above 0, and the possible part, where the second is.
struct HeavyCell {
  std::uint64_t key = 0;
  float gradient[3] = {};
  float over = 0, below = 0, above = 0;

  double at(const Vec3& y) const noexcept {
    return double{over} + (double{gradient[0]} * y.x + double{gradient[1]} * y.y + double{gradient[2]} * y.z);
  }
  /// By how much the linear part changes from the centre to the farthest corner.
  double swing(double half) const noexcept {
    return half *
           (std::fabs(double{gradient[0]}) + std::fabs(double{gradient[1]}) + std::fabs(double{gradient[2]}));
  }
  /// No point of the cube is above T by more.
  double most(double half) const noexcept { return double{over} + swing(half) + double{above}; }
  /// All of the cube is deeper than T.
  bool is_inner(double half) const noexcept { return double{over} - swing(half) - double{below} > 0; }
  /// Some point of it surely is.
  bool has_core(double half) const noexcept { return double{over} + swing(half) - double{below} > 0; }
};
static_assert(sizeof(HeavyCell) == 32);

}  // namespace cdfr
