#include "geometry/triangle_box.h"

#include <gtest/gtest.h>

#include "support/random.h"

namespace cdfr {
namespace {

const Box unit{{0, 0, 0}, {1, 1, 1}};

TEST(TriangleBox, TouchingCountsAndAGapDoesNot) {
  EXPECT_TRUE(may_touch({Vec3{1, 0, 0}, Vec3{1, 1, 0}, Vec3{2, 0, 0}}, unit));
  EXPECT_FALSE(may_touch({Vec3{1.001, 0, 0}, Vec3{1.001, 1, 0}, Vec3{2, 0, 0}}, unit));
  // Cuts off a corner without a vertex or an edge in the box, and just misses it.
  EXPECT_TRUE(may_touch({Vec3{2.9, 0, 0}, Vec3{0, 2.9, 0}, Vec3{0, 0, 2.9}}, unit));
  EXPECT_FALSE(may_touch({Vec3{3.1, 0, 0}, Vec3{0, 3.1, 0}, Vec3{0, 0, 3.1}}, unit));
}

TEST(TriangleBox, NeverMissesATriangleWithAPointInside) {
  test::Random random(10);
  const Box around{{-3, -3, -3}, {4, 4, 4}};
  for (int i = 0; i < 50000; ++i) {
    const std::array<Vec3, 3> t{random.in(around), random.in(around), random.in(around)};
    double s = random.between(0, 1), r = random.between(0, 1);
    if (s + r > 1) {
      s = 1 - s;
      r = 1 - r;
    }
    const Vec3 p{t[0].x + s * (t[1].x - t[0].x) + r * (t[2].x - t[0].x),
                 t[0].y + s * (t[1].y - t[0].y) + r * (t[2].y - t[0].y),
                 t[0].z + s * (t[1].z - t[0].z) + r * (t[2].z - t[0].z)};
    const bool inside = p.x >= 0 && p.x <= 1 && p.y >= 0 && p.y <= 1 && p.z >= 0 && p.z <= 1;
    if (inside) {
      EXPECT_TRUE(may_touch(t, unit));
    }
  }
}

}  // namespace
}  // namespace cdfr
