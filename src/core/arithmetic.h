/// Sine, cosine and angles in plain IEEE double arithmetic: the same bits on every processor, which a C
/// library does not promise.
#pragma once

#include "cdfr/core/types.h"

namespace cdfr {

/// Within 1 ulp for |x| <= 2^20; NaN beyond, and for NaN.
double sine(double x) noexcept;
double cosine(double x) noexcept;

/// Angle of the point (x, y) in [-pi, pi], with the signs of zero as IEEE 754 has them. Both arguments
/// finite, or NaN comes back. Within 4 ulp where the smaller of |y/x| and |x/y| is no subnormal number.
double arctangent2(double y, double x) noexcept;

/// Angle in [0, pi] between two vectors, 0 if one of them is zero. Relative error below 16 * 2^-53 down to
/// the smallest angles. Coordinates: 0, or 2^-200 to 2^200 in size.
double angle_between(Vec3 u, Vec3 v) noexcept;

}  // namespace cdfr
