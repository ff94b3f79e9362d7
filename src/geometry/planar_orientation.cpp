#include "geometry/planar_orientation.h"

#include <cmath>

#include "geometry/expansion.h"

namespace cdfr {
namespace {

struct Planar {
  double u = 0, v = 0;
};

Planar without(const Vec3& p, int axis) noexcept {
  if (axis == 0) return {p.y, p.z};
  if (axis == 1) return {p.z, p.x};
  return {p.x, p.y};
}

int exact_planar_orientation(const Planar& a, const Planar& b, const Planar& c) noexcept {
  return (exact_difference(b.u, a.u) * exact_difference(c.v, a.v) -
          exact_difference(b.v, a.v) * exact_difference(c.u, a.u))
      .sign();
}

}  // namespace

int planar_orientation(const Vec3& a, const Vec3& b, const Vec3& c, int axis) noexcept {
  const Planar p = without(a, axis), q = without(b, axis), r = without(c, axis);
  const double left = (q.u - p.u) * (r.v - p.v);
  const double right = (q.v - p.v) * (r.u - p.u);
  // Each product carries two differences and a multiplication, then comes one subtraction: below 4u of the
  // sum of absolute products; 8u covers second order and the rounding of that sum.
  const double permanent = std::fabs(left) + std::fabs(right);
  const double bound = 8 * unit_roundoff * permanent;
  if (left - right > bound) return 1;
  if (left - right < -bound) return -1;
  // A difference is 0 only if it is exactly, and products do not underflow: nothing is left to decide. Parts
  // with faces along the axes come here often.
  if (permanent == 0) return 0;
  return exact_planar_orientation(p, q, r);
}

}  // namespace cdfr
