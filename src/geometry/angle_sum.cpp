#include "geometry/angle_sum.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/arithmetic.h"
#include "geometry/offset.h"

namespace cdfr {
namespace {

double times(const Vec3& a, const Vec3& b) noexcept { return a.x * b.x + a.y * b.y + a.z * b.z; }

Vec3 direction(const Vec3& from, const Vec3& to) noexcept {
  const Vec3 v = minus(to, from);
  const double shorter = 1 / std::sqrt(times(v, v));
  return {v.x * shorter, v.y * shorter, v.z * shorter};
}

}  // namespace

AngleSum::Complex AngleSum::half_angle(const Vec3& a, const Vec3& b, const Vec3& c) noexcept {
  return {1 + times(a, b) + times(b, c) + times(c, a),
          a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) + a.z * (b.x * c.y - b.y * c.x)};
}

AngleSum::Complex AngleSum::product(const Complex& f, const Complex& g) noexcept {
  return {f.real * g.real - f.imaginary * g.imaginary, f.real * g.imaginary + f.imaginary * g.real};
}

/// Each factor's argument is within (-pi, pi). Two of one sign add up to more than pi if the sign of the
/// product's is the other one.
///
/// Directions are off by less than 8u, so real and imaginary part of a triangle's number by less than 128u
/// each, and arguments by that over the modulus; a product of two by twice that over the smaller one, and
/// neither modulus is above 4. So with the modulus m of what is added, 2^-40 / m covers the error of the
/// angle, twice the argument, and the rounding of the products. An argument that rounding may carry over pi,
/// and a modulus that says little, are left open.
void AngleSum::add(const Complex& half, double modulus) noexcept {
  const bool is_open =
      !(modulus > 0x1p-20) || (half.real < 0 && std::fabs(half.imaginary) < 0x1p-20 * -half.real);
  error_ += is_open ? std::numeric_limits<double>::infinity() : 0x1p-40 / modulus;
  const Complex next = product(product_, half);
  const bool before = product_.imaginary < 0, added = half.imaginary < 0, after = next.imaginary < 0;
  if (before == added && after != before) turns_ += before ? -1 : 1;
  const double shorter = 1 / (std::fabs(next.real) + std::fabs(next.imaginary));
  product_ = {next.real * shorter, next.imaginary * shorter};
}

/// The parallelogram takes up less than half a sphere, so the argument of the product of its two triangles'
/// is within (-pi, pi).
void AngleSum::add_swept(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b) noexcept {
  const Vec3 pa = direction(p, a), pb = direction(p, b), qb = direction(q, b), qa = direction(q, a);
  const Complex f = half_angle(pa, pb, qb), g = half_angle(pa, qb, qa);
  const double smaller = std::min(f.real * f.real + f.imaginary * f.imaginary,
                                  g.real * g.real + g.imaginary * g.imaginary);
  add(product(f, g), smaller / 4);
}

void AngleSum::add_to_infinity(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& direction_there) noexcept {
  const Complex f = half_angle(direction(p, a), direction(p, b), direction_there);
  add(f, (f.real * f.real + f.imaginary * f.imaginary) / 4);
}

Bounded AngleSum::sum() const noexcept {
  return {2 * arctangent2(product_.imaginary, product_.real) + turns_ * four_pi, error_ + 0x1p-48};
}

}  // namespace cdfr
