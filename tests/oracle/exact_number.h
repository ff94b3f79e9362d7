/// Exact numbers for the oracle: every double is an integer times a power of two, so integers are all it
/// takes.
#pragma once

#include <gmpxx.h>

#include <span>

#include "cdfr/core/types.h"

namespace cdfr::oracle {

using Integer = mpz_class;

struct IntegerVector {
  Integer x, y, z;
};

IntegerVector operator-(const IntegerVector& a, const IntegerVector& b);
Integer dot(const IntegerVector& a, const IntegerVector& b);
IntegerVector cross(const IntegerVector& a, const IntegerVector& b);

/// Largest e such that every coordinate is an integer times 2^e; 0 if all are zero. Precondition: finite.
int common_exponent(std::span<const Vec3> points);
/// The point in units of 2^exponent. Precondition: exponent <= common_exponent of it.
IntegerVector on_lattice(Vec3 point, int exponent);

/// numerator / denominator * 2^exponent; the denominator is positive.
struct Ratio {
  Integer numerator = 0;
  Integer denominator = 1;
  int exponent = 0;
};

/// Negative, zero or positive as a <, =, > b.
int compare(const Ratio& a, const Ratio& b);
/// Square root, never too large, and too small by less than 2^-158 of itself. Precondition: not negative.
Ratio square_root(const Ratio& square);
/// The double below or above it that is nearest or next to nearest. Precondition: in the range of doubles.
double approximate(const Ratio& value);
/// |computed - value| in units of 2^unit, to within a few 2^-53 of itself; infinity if `computed` is not
/// finite.
double difference(double computed, const Ratio& value, int unit);

/// Binary exponent of an ulp at that magnitude; never below that of the smallest double.
int ulp_exponent(double magnitude);
double largest_coordinate(Vec3 point);
double largest_coordinate(std::span<const Vec3> points);

}  // namespace cdfr::oracle
