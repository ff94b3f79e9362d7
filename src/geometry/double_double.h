/// Double-double arithmetic: an unevaluated sum hi + lo of two doubles, |lo| <= ulp(hi)/2, about 106 bits.
///
/// With u = 2^-53 the relative errors are below 3u^2 (sum), 7u^2 (product) and 15u^2 (quotient): Joldes,
/// Muller, Popescu, "Tight and rigorous error bounds for basic building blocks of double-word arithmetic",
/// 2017. Products are split by Dekker's method. A fused multiply-add gives the same rest, for it is exact
/// (double_double_lanes.inc); elsewhere there is none, so the bits are the same on every processor. Nothing
/// here under- or overflows for operands of 2^-400 to 2^400.
#pragma once

#include <array>
#include <cmath>

#include "cdfr/core/types.h"

namespace cdfr {

/// Half the spacing of doubles at 1: the unit of every rounding bound in this room.
inline constexpr double unit_roundoff = 0x1p-53;

struct DoubleDouble {
  double hi = 0, lo = 0;
  friend bool operator==(const DoubleDouble&, const DoubleDouble&) = default;
};

/// a + b exactly (Knuth).
inline DoubleDouble two_sum(double a, double b) noexcept {
  const double s = a + b;
  const double t = s - a;
  return {s, (a - (s - t)) + (b - t)};
}

/// a - b exactly.
inline DoubleDouble two_difference(double a, double b) noexcept { return two_sum(a, -b); }

/// a + b exactly, if |a| >= |b| or a == 0 (Dekker).
inline DoubleDouble quick_two_sum(double a, double b) noexcept {
  const double s = a + b;
  return {s, b - (s - a)};
}

/// a as a sum of two numbers of 26 bits each (Veltkamp).
inline DoubleDouble split(double a) noexcept {
  const double c = 0x1.0000002p27 * a;
  const double hi = c - (c - a);
  return {hi, a - hi};
}

/// a * b exactly (Dekker).
inline DoubleDouble two_product(double a, double b) noexcept {
  const double p = a * b;
  const DoubleDouble x = split(a);
  const DoubleDouble y = split(b);
  return {p, ((x.hi * y.hi - p) + x.hi * y.lo + x.lo * y.hi) + x.lo * y.lo};
}

inline DoubleDouble operator-(DoubleDouble a) noexcept { return {-a.hi, -a.lo}; }

inline DoubleDouble operator+(DoubleDouble a, DoubleDouble b) noexcept {
  const DoubleDouble s = two_sum(a.hi, b.hi);
  const DoubleDouble t = two_sum(a.lo, b.lo);
  const DoubleDouble v = quick_two_sum(s.hi, s.lo + t.hi);
  return quick_two_sum(v.hi, t.lo + v.lo);
}

inline DoubleDouble operator-(DoubleDouble a, DoubleDouble b) noexcept { return a + -b; }

inline DoubleDouble operator*(DoubleDouble a, DoubleDouble b) noexcept {
  const DoubleDouble p = two_product(a.hi, b.hi);
  return quick_two_sum(p.hi, p.lo + (a.hi * b.lo + a.lo * b.hi));
}

inline DoubleDouble operator*(DoubleDouble a, double b) noexcept {
  const DoubleDouble p = two_product(a.hi, b);
  return quick_two_sum(p.hi, p.lo + a.lo * b);
}

/// Precondition: b is not zero.
inline DoubleDouble operator/(DoubleDouble a, DoubleDouble b) noexcept {
  const double q = a.hi / b.hi;
  const DoubleDouble rest = a - b * q;
  return quick_two_sum(q, (rest.hi + rest.lo) / b.hi);
}

inline bool operator<(DoubleDouble a, DoubleDouble b) noexcept {
  return a.hi < b.hi || (a.hi == b.hi && a.lo < b.lo);
}

/// Square root rounded to double: off by at most (1/2 + 2^-50) ulp. One Newton step on the double root, whose
/// square two_product knows exactly. Precondition: a >= 0.
inline double square_root(DoubleDouble a) noexcept {
  if (!(a.hi > 0)) return 0;
  const double s = std::sqrt(a.hi);
  const DoubleDouble square = two_product(s, s);
  return s + ((a.hi - square.hi) - square.lo + a.lo) / (2 * s);
}

using DoubleDouble3 = std::array<DoubleDouble, 3>;

/// p - q without error.
inline DoubleDouble3 difference(const Vec3& p, const Vec3& q) noexcept {
  return {two_difference(p.x, q.x), two_difference(p.y, q.y), two_difference(p.z, q.z)};
}

/// Within 24u^2 of P, the sum of |a_i b_i|. High parts are multiplied and added without error; what that
/// leaves, and the products with low parts, are added in plain doubles (Ogita, Rump, Oishi, "Accurate sum and
/// dot product", 2005), all side by side. Products of low parts are left out: u^2 P. The rests of a product
/// and its two mixed products round by 7u^2 P, their sum, at most 3u P in size, by 6u^2 P, that of the sums'
/// rests, at most 2u P, by 2u^2 P, and both together by 5u^2 P: 21u^2 P.
inline DoubleDouble dot(const DoubleDouble3& a, const DoubleDouble3& b) noexcept {
  double product[3], rest[3];
  for (int i = 0; i < 3; ++i) {
    const DoubleDouble p = two_product(a[i].hi, b[i].hi);
    product[i] = p.hi;
    rest[i] = p.lo + (a[i].hi * b[i].lo + a[i].lo * b[i].hi);
  }
  const DoubleDouble two = two_sum(product[0], product[1]);
  const DoubleDouble three = two_sum(two.hi, product[2]);
  return two_sum(three.hi, (rest[0] + rest[1] + rest[2]) + (two.lo + three.lo));
}

inline DoubleDouble3 cross(const DoubleDouble3& a, const DoubleDouble3& b) noexcept {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline DoubleDouble3 scaled(const DoubleDouble3& a, DoubleDouble factor) noexcept {
  return {a[0] * factor, a[1] * factor, a[2] * factor};
}

inline Vec3 rounded(const DoubleDouble3& a) noexcept { return {a[0].hi, a[1].hi, a[2].hi}; }

}  // namespace cdfr
