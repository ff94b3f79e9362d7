/// Exact signs in the plane: on which side of a line a point lies once a coordinate is left out.
#pragma once

#include <cmath>

#include "cdfr/core/types.h"
#include "geometry/double_double.h"

namespace cdfr {

struct PlanarPoint {
  double u = 0, v = 0;
};

/// The point as seen along axis 0, 1 or 2: a turn to the left stays one.
inline PlanarPoint seen_along(int axis, const Vec3& p) noexcept {
  if (axis == 0) return {p.y, p.z};
  if (axis == 1) return {p.z, p.x};
  return {p.x, p.y};
}

/// planar_orientation by expansions, for what the filter leaves open.
int exact_planar_orientation(const PlanarPoint& a, const PlanarPoint& b, const PlanarPoint& c) noexcept;

/// Sign of (b - a) x (c - a): 1 if the way from a over b to c turns left, 0 exactly if they lie on one line.
/// Precondition: coordinates as in query_range.h. A double-precision filter answers nearly always. Source:
/// Shewchuk 1997, orient2d.
inline int planar_orientation(const PlanarPoint& a, const PlanarPoint& b, const PlanarPoint& c) noexcept {
  const double left = (b.u - a.u) * (c.v - a.v);
  const double right = (b.v - a.v) * (c.u - a.u);
  // Each product carries two differences and a multiplication, then comes one subtraction: below 4u of the
  // sum of absolute products; 8u covers second order and the rounding of that sum.
  const double permanent = std::fabs(left) + std::fabs(right);
  const double bound = 8 * unit_roundoff * permanent;
  if (left - right > bound) return 1;
  if (left - right < -bound) return -1;
  // A difference is 0 only if it is exactly, and products do not underflow: nothing is left to decide. Parts
  // with faces along the axes come here often.
  if (permanent == 0) return 0;
  return exact_planar_orientation(a, b, c);
}

}  // namespace cdfr
