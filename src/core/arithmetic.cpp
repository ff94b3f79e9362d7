#include "core/arithmetic.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace cdfr {
namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// An unevaluated sum: low is at most half an ulp of high.
struct Pair {
  double high = 0, low = 0;
};

/// a - b without error (Knuth's two-sum, for any order of sizes).
Pair exact_difference(double a, double b) noexcept {
  const double high = a - b;
  const double b_seen = a - high;
  const double a_seen = high + b_seen;
  return {high, (a - a_seen) - (b - b_seen)};
}

/// a * b without error (Dekker); sizes between 2^-440 and 2^440, or zero.
Pair exact_product(double a, double b) noexcept {
  const auto split = [](double x) {
    const double far = x * 134217729.0;  // 2^27 + 1
    const double high = far - (far - x);
    return Pair{high, x - high};
  };
  const double high = a * b;
  const Pair p = split(a);
  const Pair q = split(b);
  return {high, ((p.high * q.high - high) + p.high * q.low + p.low * q.high) + p.low * q.low};
}

/// x = quarter * pi/2 + (rest.high + rest.low), |rest| <= pi/4 up to rounding.
struct Reduced {
  Pair rest;
  std::int64_t quarter = 0;
};

/// pi/2 is cut into three parts of 33 bits and a fourth of 53. For |x| <= 2^20 the quarter has at most 20
/// bits, so its products with the first three are exact; the first difference is exact as well, being a
/// multiple of 2^-53 smaller than 1. What is lost is the rounding of the fourth product, under 2^20 * 2^-104
/// * 2^-53 = 2^-137, and of the sum of the low words, under 2^-105 of the rest. No double up to 2^20 comes
/// closer than about 2^-62 to a multiple of pi/2 other than 0, so the rest holds more than 70 correct bits.
Reduced reduce(double x) noexcept {
  constexpr double two_over_pi = 0x1.45f306dc9c883p-1;
  constexpr double part1 = 0x1.921fb544p+0;
  constexpr double part2 = 0x1.0b4611a6p-34;
  constexpr double part3 = 0x1.3198a2ep-69;
  constexpr double part4 = 0x1.b839a252049c1p-104;
  const auto quarter = static_cast<std::int64_t>(x * two_over_pi + (x < 0 ? -0.5 : 0.5));
  if (quarter == 0) return {{x, 0}, 0};
  const auto times = static_cast<double>(quarter);
  const Pair second = exact_difference(x - times * part1, times * part2);
  const Pair third = exact_difference(second.high, times * part3);
  const Pair fourth = exact_difference(third.high, times * part4);
  const double low = second.low + third.low + fourth.low;
  const double high = fourth.high + low;
  return {{high, (fourth.high - high) + low}, quarter};
}

/// Taylor's series to the 17th power; the next term is below 2^-63 of the result for |r| <= pi/4. The
/// rounding of everything but the last sum is below |r^3/6| * 2^-51, so the error stays under 0.5 + 0.3 ulp.
double sine_of_rest(Pair r) noexcept {
  const double z = r.high * r.high;
  double tail = 1.0 / 355687428096000;
  for (const double term :
       {-1.0 / 1307674368000, 1.0 / 6227020800, -1.0 / 39916800, 1.0 / 362880, -1.0 / 5040, 1.0 / 120}) {
    tail = term + z * tail;
  }
  tail = -1.0 / 6 + z * tail;
  return r.high + (r.high * z * tail + r.low * (1 - 0.5 * z));
}

/// To the 18th power; the next term is below 2^-67. 1 - z/2 is taken with its rounding error.
double cosine_of_rest(Pair r) noexcept {
  const double z = r.high * r.high;
  double tail = -1.0 / 6402373705728000;
  for (const double term :
       {1.0 / 20922789888000, -1.0 / 87178291200, 1.0 / 479001600, -1.0 / 3628800, 1.0 / 40320, -1.0 / 720}) {
    tail = term + z * tail;
  }
  tail = 1.0 / 24 + z * tail;
  const double half = 0.5 * z;
  const double most = 1 - half;
  return most + (((1 - most) - half) + (z * z * tail - r.high * r.low));
}

/// sin(x + shift * pi/2)
double shifted_sine(double x, int shift) noexcept {
  constexpr double limit = 1048576;  // 2^20
  if (!(std::abs(x) <= limit)) return not_a_number;
  const Reduced reduced = reduce(x);
  const auto turn = static_cast<unsigned>((reduced.quarter + shift) & 3);
  const double value = (turn & 1U) != 0 ? cosine_of_rest(reduced.rest) : sine_of_rest(reduced.rest);
  return (turn & 2U) != 0 ? -value : value;
}

/// arctan(k/8) as high + low.
constexpr std::array<Pair, 9> eighths{{{0, 0},
                                       {0x1.fd5ba9aac2f6ep-4, -0x1.cd37686760c17p-59},
                                       {0x1.f5b75f92c80ddp-3, 0x1.8ab6e3cf7afbdp-57},
                                       {0x1.6f61941e4def1p-2, -0x1.c63aae6f6e918p-56},
                                       {0x1.dac670561bb4fp-2, 0x1.a2b7f222f65e2p-56},
                                       {0x1.1e00babdefeb4p-1, -0x1.928df287a668fp-58},
                                       {0x1.4978fa3269ee1p-1, 0x1.2419a87f2a458p-56},
                                       {0x1.700a7c5784634p-1, -0x1.8c34d25aadef6p-56},
                                       {0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55}}};

/// arctan(q) = arctan(c) + arctan(d) with d = (q - c)/(1 + q c) for 0 <= q <= 1, c the nearest eighth, and c
/// = 0 below 1/8. There |d| <= 1/8 and the series to the 17th power leaves 2^-61 of the result. q - c is
/// exact (Sterbenz), so d is within 2.5 u, u = 2^-53; |d| is at most a third of the result where c > 0, and
/// where c = 0 it is q itself: the error is below 2.5 u of the result in either case.
double arctangent_of_ratio(double q) noexcept {
  const int k = q < 0.125 ? 0 : (static_cast<int>(q * 16) + 1) / 2;
  const double c = k * 0.125;
  const double d = k == 0 ? q : (q - c) / (1 + q * c);
  const double z = d * d;
  double tail = 1.0 / 17;
  for (const double term : {-1.0 / 15, 1.0 / 13, -1.0 / 11, 1.0 / 9, -1.0 / 7, 1.0 / 5, -1.0 / 3}) {
    tail = term + z * tail;
  }
  const Pair base = eighths[static_cast<std::size_t>(k)];
  return base.high + (d + (base.low + d * z * tail));
}

/// a*b - c*d with an error below 4 u of the result and u^2 of the products.
double difference_of_products(double a, double b, double c, double d) noexcept {
  const Pair p = exact_product(a, b);
  const Pair q = exact_product(c, d);
  const Pair high = exact_difference(p.high, q.high);
  return high.high + (high.low + (p.low - q.low));
}

/// A power of two that brings the largest coordinate into [1, 2); 0 for the zero vector.
double scale_of(Vec3 v) noexcept {
  const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  if (!(largest > 0)) return 0;
  const auto exponent = std::bit_cast<std::uint64_t>(largest) >> 52U;
  return std::bit_cast<double>((2046 - exponent) << 52U);
}

Vec3 scaled(Vec3 v, double by) noexcept { return {v.x * by, v.y * by, v.z * by}; }

}  // namespace

/// The sums would turn -0 into 0.
double sine(double x) noexcept { return x == 0 ? x : shifted_sine(x, 0); }

double cosine(double x) noexcept { return shifted_sine(x, 1); }

/// The quotient is within u, its arctangent within 2.5 u more; a difference from pi/2 or pi adds one rounding
/// and is no smaller than what it is taken from. In all less than 4 ulp.
double arctangent2(double y, double x) noexcept {
  const double across = std::abs(x);
  const double up = std::abs(y);
  if (!(across <= std::numeric_limits<double>::max() && up <= std::numeric_limits<double>::max())) {
    return not_a_number;
  }
  const double larger = std::max(across, up);
  double angle = larger > 0 ? arctangent_of_ratio(std::min(across, up) / larger) : 0;
  const Pair right = {0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54};
  if (up > across) angle = right.high - (angle - right.low);
  if (std::signbit(x)) angle = 2 * right.high - (angle - 2 * right.low);
  return std::copysign(angle, y);
}

/// Scaled by powers of two the coordinates are below 2. Each coordinate of the cross product is right to 4 u
/// of itself however parallel the vectors are; its length is scaled again, for its square can be as small as
/// 2^-1600. The cosine's error, a few u, is absolute and turns the angle by as much, which counts only where
/// the angle is large.
double angle_between(Vec3 u, Vec3 v) noexcept {
  const Vec3 a = scaled(u, scale_of(u));
  const Vec3 b = scaled(v, scale_of(v));
  const Vec3 cross{difference_of_products(a.y, b.z, a.z, b.y), difference_of_products(a.z, b.x, a.x, b.z),
                   difference_of_products(a.x, b.y, a.y, b.x)};
  const double scale = scale_of(cross);
  const Vec3 c = scaled(cross, scale);
  const double length = scale > 0 ? std::sqrt(c.x * c.x + c.y * c.y + c.z * c.z) / scale : 0;
  return arctangent2(length, a.x * b.x + a.y * b.y + a.z * b.z);
}

}  // namespace cdfr
