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
};
static_assert(sizeof(HeavyCell) == 32);

/// A point of a cell that is surely deeper than T.
struct CorePoint {
  Vec3 y;           ///< from the cell's centre, in edges of the lattice
  double over = 0;  ///< its depth is above T by that at least; not above 0 if there is no such point
};

/// T in edges of the lattice, and when two cells surely hang together.
class CoreRule {
 public:
  CoreRule(const Threshold& threshold, const Lattice& lattice) noexcept
      : depth_(threshold.depth / lattice.edge),
        rounding_(threshold.rounding / lattice.edge),
        jumps_(threshold.jumps) {}

  /// The centre, if it is deep enough itself: its depth is `over` but for rounding. Else where the sure part
  /// reaches deepest, unless the sign jumps: then ways have to stay in the two cells, which those between
  /// centres do.
  CorePoint core_point(const HeavyCell& cell, double half) const noexcept {
    const double own = double{cell.over} * (1 - 0x1p-20) - rounding_;
    if (own > 0 || jumps_) return {{}, own};
    const auto corner = [&](int axis) { return std::copysign(half, double{cell.gradient[axis]}); };
    return {{corner(0), corner(1), corner(2)}, double{cell.over} + cell.swing(half) - double{cell.below}};
  }

  /// Is the straight way between two points, `apart` from each other, all deeper than T? Their depths are
  /// above T by a and b. The squared distance to any set less |x|^2 is concave (octree/influence.h), so at
  /// the share t of the way
  ///     d^2 >= (1 - t) d_a^2 + t d_b^2 - t (1 - t) apart^2,
  /// of which the least value is taken. Between equal depths the way is deeper than T where a > apart^2 / (8
  /// T).
  bool joins(double a, double b, double squared_apart) const noexcept {
    if (!(a > 0) || !(b > 0)) return false;
    const double from = a * (2 * depth_ + a), to = b * (2 * depth_ + b);
    const double t = (squared_apart + from - to) / 2;
    if (t <= 0 || t >= squared_apart) return true;
    return from * squared_apart * (1 - 0x1p-40) > t * t;
  }

 private:
  double depth_, rounding_;
  bool jumps_;
};

}  // namespace cdfr
