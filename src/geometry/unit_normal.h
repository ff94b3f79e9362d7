/// A triangle's unit normal in double-double, whatever its aspect.
#pragma once

#include "cdfr/core/types.h"
#include "geometry/double_double.h"

namespace cdfr {

/// True if the three points lie on one line, exactly: the triangle's area is zero.
bool collinear(const Vec3& a, const Vec3& b, const Vec3& c) noexcept;

/// Unit normal by the right hand, or zero if the points are collinear. The cross product is exact until it is
/// rounded to double-double (2^-100), squares, Newton step and scaling add less than 2^-99: each component is
/// within 2^-98 of the truth at any aspect ratio. The bits do not depend on the order of the vertices but for
/// the sign.
DoubleDouble3 unit_normal(const Vec3& a, const Vec3& b, const Vec3& c) noexcept;

}  // namespace cdfr
