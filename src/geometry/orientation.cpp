#include "geometry/orientation.h"

#include <array>
#include <cmath>

#include "geometry/expansion.h"

namespace cdfr {
namespace {

int exact_orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p) noexcept {
  const std::array e{exact_difference(b.x, a.x), exact_difference(b.y, a.y), exact_difference(b.z, a.z)};
  const std::array f{exact_difference(c.x, a.x), exact_difference(c.y, a.y), exact_difference(c.z, a.z)};
  const std::array r{exact_difference(p.x, a.x), exact_difference(p.y, a.y), exact_difference(p.z, a.z)};
  return ((e[1] * f[2] - e[2] * f[1]) * r[0] + (e[2] * f[0] - e[0] * f[2]) * r[1] +
          (e[0] * f[1] - e[1] * f[0]) * r[2])
      .sign();
}

}  // namespace

int orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p) noexcept {
  const double ex = b.x - a.x, ey = b.y - a.y, ez = b.z - a.z;
  const double fx = c.x - a.x, fy = c.y - a.y, fz = c.z - a.z;
  const double rx = p.x - a.x, ry = p.y - a.y, rz = p.z - a.z;
  const double determinant = (ey * fz - ez * fy) * rx + (ez * fx - ex * fz) * ry + (ex * fy - ey * fx) * rz;
  // Each of the six products carries three differences and two multiplications, then one subtraction, one
  // more multiplication is counted, and two sums: below 8u of the sum of absolute products; 16u covers second
  // order and the rounding of `permanent` itself.
  const double permanent = (std::fabs(ey * fz) + std::fabs(ez * fy)) * std::fabs(rx) +
                           (std::fabs(ez * fx) + std::fabs(ex * fz)) * std::fabs(ry) +
                           (std::fabs(ex * fy) + std::fabs(ey * fx)) * std::fabs(rz);
  const double bound = 16 * unit_roundoff * permanent;
  if (determinant > bound) return 1;
  if (determinant < -bound) return -1;
  return exact_orientation(a, b, c, p);
}

}  // namespace cdfr
