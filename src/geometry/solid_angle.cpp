#include "geometry/solid_angle.h"

#include <cmath>

#include "core/arithmetic.h"
#include "geometry/double_double.h"
#include "geometry/orientation.h"

namespace cdfr {
namespace {

struct Fraction {
  double numerator, denominator;
  double size;  ///< |a||b||c|
};

Fraction in_double(const Vec3& p, const std::array<Vec3, 3>& t) noexcept {
  const auto from = [&](const Vec3& v) { return Vec3{v.x - p.x, v.y - p.y, v.z - p.z}; };
  const auto times = [](const Vec3& u, const Vec3& v) { return u.x * v.x + u.y * v.y + u.z * v.z; };
  const Vec3 a = from(t[0]), b = from(t[1]), c = from(t[2]);
  const double la = std::sqrt(times(a, a)), lb = std::sqrt(times(b, b)), lc = std::sqrt(times(c, c));
  const double determinant =
      a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) + a.z * (b.x * c.y - b.y * c.x);
  const double size = la * lb * lc;
  return {determinant, size + times(a, b) * lc + times(b, c) * la + times(c, a) * lb, size};
}

constexpr double whole_turn = 6.2831853071795862;

/// Square root to 2^-100 of itself: one Newton step on the double root.
DoubleDouble root(DoubleDouble x) noexcept {
  const double s = std::sqrt(x.hi);
  if (!(s > 0)) return {};
  const DoubleDouble rest = x - two_product(s, s);
  return quick_two_sum(s, rest.hi / (2 * s));
}

Fraction in_double_double(const Vec3& p, const std::array<Vec3, 3>& t) noexcept {
  const DoubleDouble3 a = difference(t[0], p), b = difference(t[1], p), c = difference(t[2], p);
  const DoubleDouble la = root(dot(a, a)), lb = root(dot(b, b)), lc = root(dot(c, c));
  const DoubleDouble size = la * lb * lc;
  const DoubleDouble denominator = size + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb;
  return {dot(a, cross(b, c)).hi, denominator.hi, size.hi};
}

}  // namespace

/// In double each of the terms, none larger than `size` but for six products of the determinant, carries
/// fewer than 12 roundings: numerator and denominator are off by less than 2^-46 size together, in
/// double-double by 2^-92 size. The angle is off by that over the length of (numerator, denominator), twice
/// for the half angle.
Bounded solid_angle(const Vec3& p, const std::array<Vec3, 3>& triangle) noexcept {
  Fraction f = in_double(p, triangle);
  double doubt = 0x1p-46 * f.size;
  double length = std::fabs(f.numerator) + std::fabs(f.denominator);
  if (!(length > 0x1p-10 * f.size)) {
    f = in_double_double(p, triangle);
    doubt = 0x1p-92 * f.size;
    length = std::fabs(f.numerator) + std::fabs(f.denominator);
    if (!(length > 0x1p-80 * f.size)) return {0, whole_turn};
  }
  double numerator = std::fabs(f.numerator);
  if (std::fabs(f.numerator) <= doubt) {
    const int side = orientation(triangle[0], triangle[1], triangle[2], p);
    if (side == 0) return {};
    numerator = side < 0 ? numerator : -numerator;
  } else if (f.numerator < 0) {
    numerator = -numerator;
  }
  // |(n, d)| is at least 0.7 (|n| + |d|).
  return {2 * arctangent2(numerator, f.denominator), 4 * doubt / length + 0x1p-49};
}

}  // namespace cdfr
