/// The solid angle that a triangle takes up as seen from a point.
#pragma once

#include <array>

#include "cdfr/core/types.h"

namespace cdfr {

/// What the whole sphere takes up.
inline constexpr double four_pi = 12.566370614359172;

/// A number and a bound on its error.
struct Bounded {
  double value = 0;
  double error = 0;
};

/// Signed, in [-2 pi, 2 pi]: positive if p is behind the triangle, where the normal does not point. 0 for a
/// triangle of no area and for p in its plane; within 2^-80 of the border anything, with an error that says
/// so. The formula is van Oosterom's and Strackee's ("The solid angle of a plane triangle", 1983), tan(angle
/// / 2) = det(a, b, c) / (|a||b||c| + (a.b)|c| + (b.c)|a| + (c.a)|b|), which loses digits where p is near an
/// edge: there numerator and denominator are taken in double-double. The sign is exact. Precondition: the
/// range of query_range.h.
Bounded solid_angle(const Vec3& p, const std::array<Vec3, 3>& triangle) noexcept;

/// Of the triangle from, to and the point at infinity in that direction. Where p is within 2^-80 of its
/// border the error is a whole turn; where it is in its plane, and rounding hides on which side, too.
Bounded solid_angle_to_infinity(const Vec3& p, const Vec3& from, const Vec3& to,
                                const Vec3& direction) noexcept;

}  // namespace cdfr
