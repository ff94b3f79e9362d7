/// Many solid angles added up for one arctangent: half of each is the argument of a complex number (van
/// Oosterom's and Strackee's formula, solid_angle.h), and arguments add up as numbers are multiplied.
#pragma once

#include <cstddef>

#include "cdfr/core/types.h"
#include "geometry/solid_angle.h"

namespace cdfr {

class AngleSum {
 public:
  /// By how much the edge from a to b, as part of the boundary of a surface, changes the solid angle of that
  /// surface on the straight way from q to p, but for whole spheres where the way passes through the surface:
  /// the parallelogram that the edge sweeps as seen from the point. As seen from p and from q the surface and
  /// that parallelogram close up to one that winds round the point a whole number of times.
  void add_swept(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b) noexcept;

  /// The triangle of a, b and the point at infinity in that direction, a unit vector within 2u, as seen from
  /// p.
  void add_to_infinity(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& direction) noexcept;

  /// The error is infinite if a point came so near an edge that rounding may tell on which side it is.
  Bounded sum() const noexcept;

 private:
  struct Complex {
    double real, imaginary;
  };
  static Complex half_angle(const Vec3& a, const Vec3& b, const Vec3& c) noexcept;
  static Complex product(const Complex& f, const Complex& g) noexcept;
  /// `squared`: the square of the smallest modulus of its triangles.
  void add(const Complex& half, double squared) noexcept;

  Complex product_{1, 0};
  int turns_ = 0;  ///< whole turns that the argument of the product lacks
  std::size_t count_ = 0;
  double least_squared_ = 16;
  bool is_open_ = false;
};

}  // namespace cdfr
