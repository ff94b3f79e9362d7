#include "geometry/solid_angle.h"

#include <cmath>

#include "core/arithmetic.h"
#include "geometry/double_double.h"
#include "geometry/offset.h"
#include "geometry/orientation.h"

namespace cdfr {
namespace {

constexpr double whole_turn = four_pi / 2;

struct Fraction {
  double numerator, denominator;
  double size;  ///< |a||b||c|
};

/// Each vector may have any length.
Fraction in_double(const Vec3& a, const Vec3& b, const Vec3& c) noexcept {
  const auto times = [](const Vec3& u, const Vec3& v) { return u.x * v.x + u.y * v.y + u.z * v.z; };
  const double la = std::sqrt(times(a, a)), lb = std::sqrt(times(b, b)), lc = std::sqrt(times(c, c));
  const double determinant =
      a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) + a.z * (b.x * c.y - b.y * c.x);
  const double size = la * lb * lc;
  return {determinant, size + times(a, b) * lc + times(b, c) * la + times(c, a) * lb, size};
}

/// Square root to 2^-100 of itself: one Newton step on the double root.
DoubleDouble root(DoubleDouble x) noexcept {
  const double s = std::sqrt(x.hi);
  if (!(s > 0)) return {};
  const DoubleDouble rest = x - two_product(s, s);
  return quick_two_sum(s, rest.hi / (2 * s));
}

Fraction in_double_double(const DoubleDouble3& a, const DoubleDouble3& b, const DoubleDouble3& c) noexcept {
  const DoubleDouble la = root(dot(a, a)), lb = root(dot(b, b)), lc = root(dot(c, c));
  const DoubleDouble size = la * lb * lc;
  const DoubleDouble denominator = size + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb;
  return {dot(a, cross(b, c)).hi, denominator.hi, size.hi};
}

/// In double each of the terms, none larger than `size` but for six products of the determinant, carries
/// fewer than 12 roundings: numerator and denominator are off by less than 2^-46 size together, in
/// double-double by 2^-92 size.
struct Doubtful {
  Fraction fraction;
  double doubt;
};

double length(const Fraction& f) noexcept { return std::fabs(f.numerator) + std::fabs(f.denominator); }

/// In double where that will do.
template <class Precise>
Doubtful careful(const Vec3& a, const Vec3& b, const Vec3& c, Precise precise) noexcept {
  const Fraction f = in_double(a, b, c);
  if (length(f) > 0x1p-10 * f.size) return {f, 0x1p-46 * f.size};
  const Fraction g = precise();
  return {g, 0x1p-92 * g.size};
}

bool at_border(const Fraction& f) noexcept { return !(length(f) > 0x1p-80 * f.size); }

/// The angle is off by the doubt over the length of (numerator, denominator), twice for the half angle; that
/// length is at least 0.7 (|n| + |d|).
Bounded angle_of(double numerator, const Doubtful& d) noexcept {
  return {2 * arctangent2(numerator, d.fraction.denominator), 4 * d.doubt / length(d.fraction) + 0x1p-49};
}

}  // namespace

Bounded solid_angle(const Vec3& p, const std::array<Vec3, 3>& triangle) noexcept {
  const Vec3 &a = triangle[0], &b = triangle[1], &c = triangle[2];
  const Doubtful d = careful(minus(a, p), minus(b, p), minus(c, p), [&] {
    return in_double_double(difference(a, p), difference(b, p), difference(c, p));
  });
  if (at_border(d.fraction)) return {0, whole_turn};
  double numerator = d.fraction.numerator;
  if (std::fabs(numerator) <= d.doubt) {
    const int side = orientation(a, b, c, p);
    if (side == 0) return {};
    numerator = side < 0 ? std::fabs(numerator) : -std::fabs(numerator);
  }
  return angle_of(numerator, d);
}

Bounded solid_angle_to_infinity(const Vec3& p, const Vec3& from, const Vec3& to,
                                const Vec3& direction) noexcept {
  const Doubtful d = careful(minus(from, p), minus(to, p), direction, [&] {
    return in_double_double(difference(from, p), difference(to, p), difference(direction, {}));
  });
  const bool either_side = std::fabs(d.fraction.numerator) <= d.doubt && d.fraction.denominator < d.doubt;
  if (at_border(d.fraction) || either_side) return {0, whole_turn};
  return angle_of(d.fraction.numerator, d);
}

}  // namespace cdfr
