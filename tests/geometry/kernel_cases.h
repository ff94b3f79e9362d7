/// Points and triangles for tests of the kernel: faces, edges and corners, slivers up to no area at all,
/// points on features and between them, lattices where everything is a tie, all sizes.
#pragma once

#include <cmath>
#include <cstring>

#include "geometry/point_triangle.h"
#include "geometry/query_range.h"
#include "geometry/unit_normal.h"
#include "support/random.h"

namespace cdfr::test {

struct KernelCase {
  Vec3 p;
  TriangleShape triangle;
};

inline Vec3 toward(const Vec3& a, const Vec3& b, double t) {
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.z + t * (b.z - a.z)};
}

inline Vec3 shifted(const Vec3& a, const Vec3& way, double factor) {
  return {a.x + factor * way.x, a.y + factor * way.y, a.z + factor * way.z};
}

inline double power_below_one(Random& random, unsigned most) {
  return std::ldexp(1.0, -static_cast<int>(random.below(most)));
}

inline Vec3 lattice_point(Random& random) {
  const auto coordinate = [&] { return static_cast<double>(random.below(9)) - 4; };
  const double x = coordinate(), y = coordinate(), z = coordinate();
  return {x, y, z};
}

inline std::array<Vec3, 3> random_corners(Random& random) {
  const Box box{{-1, -1, -1}, {1, 1, 1}};
  const Vec3 a = random.in(box), b = random.in(box), c = random.in(box);
  const double flat = power_below_one(random, 60);
  switch (random.below(6)) {
    case 0:  // cap or needle
      return {a, b, shifted(toward(a, b, random.between(-0.2, 1.2)), c, flat)};
    case 1:  // one short edge
      return {a, shifted(a, b, flat), c};
    case 2:
      return {lattice_point(random), lattice_point(random), lattice_point(random)};
    case 3:  // no area, up to rounding
      return {a, b, random.below(2) == 0 ? a : toward(a, b, 0.5)};
    case 4:  // axis-aligned
      return {Vec3{a.x, a.y, 0.25}, Vec3{b.x, a.y, 0.25}, Vec3{flat * c.x, c.y, 0.25}};
    default:
      return {a, b, c};
  }
}

inline Vec3 random_query(Random& random, const std::array<Vec3, 3>& v) {
  const std::uint64_t k = random.below(3);
  const Vec3 &a = v[k], &b = v[(k + 1) % 3], &c = v[(k + 2) % 3];
  const Vec3 far = random.in({{-2, -2, -2}, {2, 2, 2}});
  const double near = power_below_one(random, 110);
  const double s = random.between(0, 1), t = random.between(0, 1);
  switch (random.below(7)) {
    case 0:  // near a face, an edge, a corner
      return shifted(toward(toward(a, b, s), c, t), far, near);
    case 1:
      return shifted(toward(a, b, 1.5 * s - 0.25), far, near);
    case 2:
      return shifted(a, far, near);
    case 3:
      return lattice_point(random);
    case 4:  // along an edge
      return toward(a, b, std::ldexp(s, static_cast<int>(random.below(40))));
    case 5:
      return shifted({}, far, std::ldexp(1.0, static_cast<int>(random.below(250))));
    default:
      return far;
  }
}

inline KernelCase random_kernel_case(Random& random) {
  std::array<Vec3, 3> v = random_corners(random);
  Vec3 p = random_query(random, v);
  const double size = random.below(4) == 0 ? std::ldexp(1.0, static_cast<int>(random.below(130)) - 80) : 1;
  for (Vec3& corner : v) corner = shifted({}, corner, size);
  p = without_dust(shifted({}, p, random.below(8) == 0 ? 1 : size));
  return {p, {v, unit_normal(v[0], v[1], v[2])}};
}

inline bool same_bits(const Foot& a, const Foot& b) {
  const auto same = [](const auto& x, const auto& y) { return std::memcmp(&x, &y, sizeof(x)) == 0; };
  return a.place == b.place && same(a.squared, b.squared) && same(a.offset, b.offset) &&
         same(a.along, b.along);
}

}  // namespace cdfr::test
