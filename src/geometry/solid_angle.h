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

/// By how much the edge from a to b, as part of the boundary of a surface, changes the solid angle of that
/// surface on the straight way from q to p, but for whole spheres where the way passes through the surface:
/// the angle of the parallelogram that the edge sweeps as seen from the point. Seen from p and q the surface
/// and that parallelogram close up to one that winds round the point a whole number of times. Where the way
/// comes so near the edge that rounding may tell on which side it passes, the error is a whole sphere.
Bounded swept_angle(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b) noexcept;

}  // namespace cdfr
