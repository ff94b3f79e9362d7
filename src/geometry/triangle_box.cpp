#include "geometry/triangle_box.h"

#include <algorithm>
#include <cmath>

#include "geometry/double_double.h"

namespace cdfr {
namespace {

using Array3 = std::array<double, 3>;

/// True if the projections on `axis` are apart by more than rounding. Everything is relative to the box's
/// centre, so a projection is off by less than 8u of |axis|_1 times the largest magnitude `reach` of what is
/// projected.
bool separates(const Array3& axis, const std::array<Array3, 3>& v, const Array3& half,
               double reach) noexcept {
  double lo = HUGE_VAL, hi = -HUGE_VAL;
  for (const Array3& p : v) {
    const double s = axis[0] * p[0] + axis[1] * p[1] + axis[2] * p[2];
    lo = std::min(lo, s);
    hi = std::max(hi, s);
  }
  const double size = std::fabs(axis[0]) + std::fabs(axis[1]) + std::fabs(axis[2]);
  const double radius =
      std::fabs(axis[0]) * half[0] + std::fabs(axis[1]) * half[1] + std::fabs(axis[2]) * half[2];
  const double slack = 32 * unit_roundoff * size * reach;
  return lo > radius + slack || hi < -radius - slack;
}

}  // namespace

bool may_touch(const std::array<Vec3, 3>& triangle, const Box& box) noexcept {
  const Array3 half{(box.hi.x - box.lo.x) / 2, (box.hi.y - box.lo.y) / 2, (box.hi.z - box.lo.z) / 2};
  const Array3 centre{box.lo.x + half[0], box.lo.y + half[1], box.lo.z + half[2]};
  std::array<Array3, 3> v;
  double reach = std::max({half[0], half[1], half[2]});
  for (int i = 0; i < 3; ++i) {
    v[i] = {triangle[i].x - centre[0], triangle[i].y - centre[1], triangle[i].z - centre[2]};
    for (const double c : v[i]) reach = std::max(reach, std::fabs(c));
  }
  for (int a = 0; a < 3; ++a) {
    Array3 axis{};
    axis[a] = 1;
    if (separates(axis, v, half, reach)) return false;
  }
  std::array<Array3, 3> e;
  for (int k = 0; k < 3; ++k) {
    for (int a = 0; a < 3; ++a) e[k][a] = v[(k + 1) % 3][a] - v[k][a];
  }
  // An axis computed with an error still separates if it separates: any axis is a valid witness.
  const Array3 normal{e[0][1] * e[1][2] - e[0][2] * e[1][1], e[0][2] * e[1][0] - e[0][0] * e[1][2],
                      e[0][0] * e[1][1] - e[0][1] * e[1][0]};
  if (separates(normal, v, half, reach)) return false;
  for (const Array3& d : e) {
    if (separates({0, -d[2], d[1]}, v, half, reach) || separates({d[2], 0, -d[0]}, v, half, reach) ||
        separates({-d[1], d[0], 0}, v, half, reach)) {
      return false;
    }
  }
  return true;
}

}  // namespace cdfr
