#include "geometry/unit_normal.h"

#include <cmath>
#include <utility>

#include "geometry/expansion.h"
#include "geometry/query_range.h"
#include "geometry/vertex_order.h"

namespace cdfr {
namespace {

using ExactCross = std::array<Expansion<16>, 3>;

ExactCross exact_cross(const Vec3& a, const Vec3& b, const Vec3& c) noexcept {
  const std::array e{exact_difference(b.x, a.x), exact_difference(b.y, a.y), exact_difference(b.z, a.z)};
  const std::array f{exact_difference(c.x, a.x), exact_difference(c.y, a.y), exact_difference(c.z, a.z)};
  return {e[1] * f[2] - e[2] * f[1], e[2] * f[0] - e[0] * f[2], e[0] * f[1] - e[1] * f[0]};
}

/// Divided by its length, after the power of two of the largest component is taken out: then the squares
/// neither over- nor underflow where it matters. 1/sqrt by one Newton step in double-double on the double
/// value: error below 2^-100.
DoubleDouble3 normalised(DoubleDouble3 n) noexcept {
  int exponent = 0;
  std::frexp(largest_magnitude(rounded(n)), &exponent);
  for (DoubleDouble& c : n) c = {std::ldexp(c.hi, -exponent), std::ldexp(c.lo, -exponent)};
  const DoubleDouble square = dot(n, n);
  const double y = 1 / std::sqrt(square.hi);
  const DoubleDouble residual = DoubleDouble{1, 0} - square * y * y;
  const DoubleDouble inverse = DoubleDouble{y, 0} + residual * (y / 2);
  return scaled(n, inverse);
}

}  // namespace

bool collinear(const Vec3& a, const Vec3& b, const Vec3& c) noexcept {
  const ExactCross n = exact_cross(a, b, c);
  return n[0].sign() == 0 && n[1].sign() == 0 && n[2].sign() == 0;
}

DoubleDouble3 unit_normal(const Vec3& a, const Vec3& b, const Vec3& c) noexcept {
  const Vec3* p[3] = {&a, &b, &c};
  bool flipped = false;
  const auto order = [&](int i, int j) {
    if (precedes(*p[j], *p[i])) {
      std::swap(p[i], p[j]);
      flipped = !flipped;
    }
  };
  order(0, 1);
  order(1, 2);
  order(0, 1);
  const ExactCross exact = exact_cross(*p[0], *p[1], *p[2]);
  DoubleDouble3 n{exact[0].rounded(), exact[1].rounded(), exact[2].rounded()};
  if (n[0].hi == 0 && n[1].hi == 0 && n[2].hi == 0) return {};
  n = normalised(n);
  if (flipped) n = {-n[0], -n[1], -n[2]};
  return n;
}

}  // namespace cdfr
