/// Bounds on the distance between points and axis-aligned boxes.
#pragma once

#include <algorithm>
#include <cmath>

#include "cdfr/core/types.h"
#include "geometry/double_double.h"

namespace cdfr {

/// Squared distance from p to the box, never too large: three differences, products and two sums round by
/// less than 6u together.
inline double squared_distance_below(const Vec3& p, const Box& box) noexcept {
  const double x = std::max(std::max(box.lo.x - p.x, p.x - box.hi.x), 0.0);
  const double y = std::max(std::max(box.lo.y - p.y, p.y - box.hi.y), 0.0);
  const double z = std::max(std::max(box.lo.z - p.z, p.z - box.hi.z), 0.0);
  return (x * x + y * y + z * z) * (1 - 8 * unit_roundoff);
}

/// Distance between two points, off by less than 4u of itself.
inline double distance_between(const Vec3& a, const Vec3& b) noexcept {
  const double x = a.x - b.x, y = a.y - b.y, z = a.z - b.z;
  return std::sqrt(x * x + y * y + z * z);
}

/// Length of the diagonal, rounded up.
inline double diagonal_above(const Box& box) noexcept {
  return distance_between(box.lo, box.hi) * (1 + 8 * unit_roundoff);
}

inline Box united(const Box& a, const Box& b) noexcept {
  return {{std::min(a.lo.x, b.lo.x), std::min(a.lo.y, b.lo.y), std::min(a.lo.z, b.lo.z)},
          {std::max(a.hi.x, b.hi.x), std::max(a.hi.y, b.hi.y), std::max(a.hi.z, b.hi.z)}};
}

/// True if the closed boxes have a point in common.
inline bool overlap(const Box& a, const Box& b) noexcept {
  return a.lo.x <= b.hi.x && a.hi.x >= b.lo.x && a.lo.y <= b.hi.y && a.hi.y >= b.lo.y && a.lo.z <= b.hi.z &&
         a.hi.z >= b.lo.z;
}

inline double longest_side(const Box& box) noexcept {
  return std::max({box.hi.x - box.lo.x, box.hi.y - box.lo.y, box.hi.z - box.lo.z});
}

inline bool contains(const Box& box, const Vec3& p) noexcept {
  return box.lo.x <= p.x && p.x <= box.hi.x && box.lo.y <= p.y && p.y <= box.hi.y && box.lo.z <= p.z &&
         p.z <= box.hi.z;
}

}  // namespace cdfr
