/// The largest ball that touches a wall at a point: thickness by closest points.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "analysis/measured_wall.h"
#include "core/progress.h"
#include "field/field_data.h"

namespace cdfr {

struct BallOptions {
  bool outside = false;
  double tolerance = 0;  ///< of the radius; at least twice the rounding
  double largest = 0;    ///< radius beyond which nothing is looked for
  double rounding = 0;   ///< ball_rounding() of it all
};

/// Bound on what a computed depth, of a centre that was computed from position and direction, may be off by:
/// the position by 8 ulp of the largest coordinate, the centre by 6 more, its distance by 4.
double ball_rounding(const FieldData& field, double largest) noexcept;

/// Let u be the direction, s(x) the depth of x in what is measured (inside, or outside), and D the facet
/// tolerance of the point. A radius r is feasible if F(r) = r - s(p + r u) <= D. s has slope at most 1, so F
/// grows, and feasible radii are an interval from 0. What bounds it from above:
///  - Every surface point q: r is infeasible if |p + r u - q| < r - D. Squared, that is r > r_q =
///    (|q - p|^2 - D^2) / (2 (u . (q - p) - D)) where u . (q - p) > D, and nothing else.
///  - An infeasible r itself, and by F's slope of at most 2 also r - (F(r) - D) / 2.
/// So the closest point of an infeasible centre gives the next bound. That is Dinkelbach's method for the
/// least r_q over the surface, which converges faster than linearly (Dinkelbach, "On nonlinear fractional
/// programming", 1967; the "shrinking ball" of Ma, Bae, Choi 2012). The radius asked about is the bound less
/// the tolerance: if that is feasible, the two are the bracket. Where steps stay short the bracket is halved.
///
/// Where the sign jumps off the surface (an open mesh) s is the unsigned distance: the ball is held by the
/// surface alone.
///
/// The first radius exceeds what fits into the mesh's box, so that there is always a q. Closest points are
/// asked of many samples at a time (field/batch.h). Each answer depends on its own sample alone. Returns the
/// number of closest points asked; nothing of use in `walls` if cancelled. Runs in one thread.
std::uint64_t largest_balls(const FieldData& field, std::span<const WallPoint> points,
                            const BallOptions& options, std::span<MeasuredWall> walls, Progress& progress);

}  // namespace cdfr
