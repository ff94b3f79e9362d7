#include "oracle/exact_number.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace cdfr::oracle {
namespace {

/// x = mantissa * 2^exponent with an odd mantissa, or mantissa 0.
struct Binary {
  long mantissa = 0;
  int exponent = 0;
};

Binary binary(double x) {
  if (x == 0) return {};
  int exponent = 0;
  const double fraction = std::frexp(x, &exponent);
  const long mantissa = static_cast<long>(std::ldexp(fraction, 53));
  const int zeros = std::countr_zero(static_cast<std::uint64_t>(mantissa));
  return {mantissa >> zeros, exponent - 53 + zeros};
}

Integer shifted(const Integer& value, int bits) {
  Integer result;
  mpz_mul_2exp(result.get_mpz_t(), value.get_mpz_t(), static_cast<mp_bitcnt_t>(bits));
  return result;
}

Integer coordinate(double x, int exponent) {
  const Binary parts = binary(x);
  if (parts.mantissa == 0) return 0;
  return shifted(Integer(parts.mantissa), parts.exponent - exponent);
}

int bits_of(const Integer& value) { return static_cast<int>(mpz_sizeinbase(value.get_mpz_t(), 2)); }

}  // namespace

IntegerVector operator-(const IntegerVector& a, const IntegerVector& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

Integer dot(const IntegerVector& a, const IntegerVector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

IntegerVector cross(const IntegerVector& a, const IntegerVector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

int common_exponent(std::span<const Vec3> points) {
  constexpr int none = std::numeric_limits<int>::max();
  int least = none;
  for (const Vec3& point : points) {
    for (const double x : {point.x, point.y, point.z}) {
      if (x != 0) least = std::min(least, binary(x).exponent);
    }
  }
  return least == none ? 0 : least;
}

IntegerVector on_lattice(Vec3 point, int exponent) {
  return {coordinate(point.x, exponent), coordinate(point.y, exponent), coordinate(point.z, exponent)};
}

int compare(const Ratio& a, const Ratio& b) {
  Integer left = a.numerator * b.denominator;
  Integer right = b.numerator * a.denominator;
  const int gap = a.exponent - b.exponent;
  if (gap > 0) left = shifted(left, gap);
  if (gap < 0) right = shifted(right, -gap);
  return cmp(left, right);
}

Ratio square_root(const Ratio& square) {
  constexpr int root_bits = 160;
  if (square.numerator == 0) return {};
  const bool odd = square.exponent % 2 != 0;
  Integer numerator = odd ? shifted(square.numerator, 1) : square.numerator;
  const int exponent = (square.exponent - (odd ? 1 : 0)) / 2;
  const int missing = 2 * root_bits - (bits_of(numerator) - bits_of(square.denominator));
  const int half = std::max(0, missing / 2 + 1);
  numerator = shifted(numerator, 2 * half) / square.denominator;
  return {sqrt(numerator), 1, exponent - half};
}

double approximate(const Ratio& value) {
  long top_exponent = 0;
  long bottom_exponent = 0;
  const double top = mpz_get_d_2exp(&top_exponent, value.numerator.get_mpz_t());
  const double bottom = mpz_get_d_2exp(&bottom_exponent, value.denominator.get_mpz_t());
  return std::ldexp(top / bottom, static_cast<int>(top_exponent - bottom_exponent) + value.exponent);
}

double difference(double computed, const Ratio& value, int unit) {
  if (!std::isfinite(computed)) return std::numeric_limits<double>::infinity();
  const Binary parts = binary(computed);
  const int exponent = parts.mantissa == 0 ? value.exponent : std::min(parts.exponent, value.exponent);
  const Integer left = shifted(Integer(parts.mantissa) * value.denominator,
                               parts.mantissa == 0 ? 0 : parts.exponent - exponent);
  const Integer gap = abs(left - shifted(value.numerator, value.exponent - exponent));
  return approximate({gap, value.denominator, exponent - unit});
}

int ulp_exponent(double magnitude) {
  constexpr int smallest = -1074;
  return magnitude > 0 ? std::max(std::ilogb(magnitude) - 52, smallest) : smallest;
}

double largest_coordinate(Vec3 point) {
  return std::max({std::abs(point.x), std::abs(point.y), std::abs(point.z)});
}

double largest_coordinate(std::span<const Vec3> points) {
  double largest = 0;
  for (const Vec3& point : points) largest = std::max(largest, largest_coordinate(point));
  return largest;
}

}  // namespace cdfr::oracle
