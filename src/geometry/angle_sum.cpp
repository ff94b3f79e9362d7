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
/// each, and its argument by less than 2^-45 over its modulus, which is 4 at most; a product of two by twice
/// that over the smaller modulus m, and the angle, twice the argument, by 2^-43 / m; 2^-42 / m covers the
/// rounding of the products. Left open is a modulus that says little, and an argument that rounding, below
/// 2^-44 / 2^-18, may carry over pi.
void AngleSum::add(const Complex& half, double squared) noexcept {
  is_open_ |= !(squared > 0x1p-36) || (half.real < 0 && std::fabs(half.imaginary) < 0x1p-20 * -half.real);
  least_squared_ = std::min(least_squared_, squared);
  ++count_;
  const Complex next = product(product_, half);
  const bool before = product_.imaginary < 0, added = half.imaginary < 0, after = next.imaginary < 0;
  if (before == added && after != before) turns_ += before ? -1 : 1;
  product_ = next;
  const double size = std::fabs(next.real) + std::fabs(next.imaginary);
  if (size > 0x1p200 || size < 0x1p-200) product_ = {next.real / size, next.imaginary / size};
}

/// The parallelogram takes up less than half a sphere, so the argument of the product of its two triangles'
/// is within (-pi, pi).
void AngleSum::add_swept(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b) noexcept {
  const Vec3 pa = direction(p, a), pb = direction(p, b), qb = direction(q, b), qa = direction(q, a);
  const Complex f = half_angle(pa, pb, qb), g = half_angle(pa, qb, qa);
  const double smaller =
      std::min(f.real * f.real + f.imaginary * f.imaginary, g.real * g.real + g.imaginary * g.imaginary);
  add(product(f, g), smaller);
}

void AngleSum::add_to_infinity(const Vec3& p, const Vec3& a, const Vec3& b,
                               const Vec3& direction_there) noexcept {
  const Complex f = half_angle(direction(p, a), direction(p, b), direction_there);
  add(f, f.real * f.real + f.imaginary * f.imaginary);
}

Bounded AngleSum::sum() const noexcept {
  if (is_open_) return {0, std::numeric_limits<double>::infinity()};
  return {2 * arctangent2(product_.imaginary, product_.real) + turns_ * four_pi,
          static_cast<double>(count_) * 0x1p-42 / std::sqrt(least_squared_) + 0x1p-48};
}

}  // namespace cdfr
