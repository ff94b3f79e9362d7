/// Groups of eight triangles of every shape that single precision may find hard.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "geometry/point_triangle.h"
#include "geometry/triangle_group.h"
#include "geometry/unit_normal.h"
#include "support/random.h"

namespace cdfr::test {

struct ShapedGroup {
  TriangleGroup group;
  std::array<TriangleShape, group_size> shapes;
};

enum class Shapes { any, slivers, needles, segments, one_point, large_and_tiny };
inline constexpr Shapes all_shapes[] = {Shapes::any,      Shapes::slivers,   Shapes::needles,
                                        Shapes::segments, Shapes::one_point, Shapes::large_and_tiny};

inline void put(ShapedGroup& to, std::size_t lane, const std::array<Vec3, 3>& corners) {
  to.shapes[lane] = {corners, unit_normal(corners[0], corners[1], corners[2])};
  for (std::size_t corner = 0; corner < 3; ++corner) {
    const Vec3& v = corners[corner];
    to.group.vertices[corner][0][lane] = v.x;
    to.group.vertices[corner][1][lane] = v.y;
    to.group.vertices[corner][2][lane] = v.z;
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    to.group.normals[axis][lane] = to.shapes[lane].normal[axis].hi;
  }
}

inline Vec3 along(const Vec3& a, const Vec3& b, double t) {
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.z + t * (b.z - a.z)};
}

/// Three corners in the box, of that shape; aspects go to 2^40.
inline std::array<Vec3, 3> corners_of(Random& random, Shapes shapes, const Box& box) {
  const Vec3 a = random.in(box), b = random.in(box), c = random.in(box);
  const double flat = std::ldexp(1.0, -static_cast<int>(random.below(41)));
  switch (shapes) {
    case Shapes::slivers:
      return {a, b, along(along(a, b, random.between(0, 1)), c, flat)};
    case Shapes::needles:
      return {a, b, along(a, c, flat)};
    case Shapes::segments:
      return {a, b, random.below(2) == 0 ? a : b};
    case Shapes::one_point:
      return {a, a, a};
    case Shapes::large_and_tiny:
      return random.below(2) == 0 ? std::array{a, b, c} : std::array{a, along(a, b, flat), along(a, c, flat)};
    case Shapes::any:
      break;
  }
  return {a, b, c};
}

/// Corners within `size` of the middle along each axis.
inline ShapedGroup shaped_group(Random& random, Shapes shapes, const Vec3& middle, double size) {
  const Box box{{middle.x - size, middle.y - size, middle.z - size},
                {middle.x + size, middle.y + size, middle.z + size}};
  ShapedGroup made;
  const auto one = corners_of(random, shapes, box);
  for (std::size_t lane = 0; lane < group_size; ++lane) {
    put(made, lane, shapes == Shapes::one_point ? one : corners_of(random, shapes, box));
  }
  return made;
}

}  // namespace cdfr::test
