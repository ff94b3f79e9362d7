#include "geometry/point_triangle.h"

#include <gtest/gtest.h>

#include <cmath>

#include "geometry/unit_normal.h"
#include "support/random.h"

namespace cdfr {
namespace {

TriangleShape shape(const Vec3& a, const Vec3& b, const Vec3& c) { return {{a, b, c}, unit_normal(a, b, c)}; }

double distance(const Vec3& p, const TriangleShape& t) { return square_root(measure(p, t).squared); }

TEST(PointTriangle, KnowsEachOfTheSevenPlaces) {
  const TriangleShape t = shape({0, 0, 0}, {4, 0, 0}, {0, 4, 0});
  const struct {
    Vec3 p;
    TrianglePlace place;
    double distance;
  } cases[] = {{{1, 1, 3}, 0, 3},  {{2, -3, 4}, 1, 5},  {{5, 5, 0}, 2, 3 * std::sqrt(2.0)},
               {{-3, 2, 4}, 3, 5}, {{-3, -4, 0}, 4, 5}, {{7, -4, 0}, 5, 5},
               {{-4, 7, 0}, 6, 5}};
  for (const auto& c : cases) {
    EXPECT_EQ(measure(c.p, t).place, c.place);
    EXPECT_DOUBLE_EQ(distance(c.p, t), c.distance);
  }
}

TEST(PointTriangle, IsZeroExactlyOnTheSurfaceAndNowhereElse) {
  const TriangleShape t = shape({0.1, 0.2, 0.3}, {0.9, 0.4, 0.3}, {0.3, 0.8, 0.3});
  EXPECT_EQ(distance({0.4, 0.4, 0.3}, t), 0);
  EXPECT_GT(distance({0.4, 0.4, std::nextafter(0.3, 1)}, t), 0);
  // A slanted plane through lattice points: on it no rounding of the normal may show.
  const TriangleShape slanted = shape({0, 0, 1}, {3, 0, 0}, {0, 5, -2});
  EXPECT_EQ(distance({1, 1, 0x1p-4}, slanted) == 0, false);
  EXPECT_EQ(distance({0.75, 1.25, 0}, slanted), 0);
  EXPECT_EQ(distance({1.5, 0, 0.5}, slanted), 0);
}

TEST(PointTriangle, SignOfTheHeightIsExactAnUlpFromASlantedPlane) {
  const TriangleShape t = shape({0, 0, 1}, {3, 0, 0}, {0, 5, -2});
  const Vec3 on{0.75, 1.25, 0};
  const Foot above = measure({on.x, on.y, 0x1p-290}, t);
  const Foot below = measure({on.x, on.y, -0x1p-290}, t);
  EXPECT_EQ(above.place, 0);
  EXPECT_GT(above.along.hi, 0);
  EXPECT_LT(below.along.hi, 0);
}

TEST(PointTriangle, BothTrianglesOfAnEdgeGiveIdenticalBits) {
  test::Random random(6);
  const Box box{{-1, -1, -1}, {1, 1, 1}};
  int edges = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vec3 a = random.in(box), b = random.in(box), c = random.in(box), d = random.in(box),
               p = random.in(box);
    const Foot one = measure(p, shape(a, b, c));
    const Foot other = measure(p, shape(b, a, d));
    if (one.place != 1 || other.place != 1) continue;
    ++edges;
    EXPECT_EQ(one.squared, other.squared);
    EXPECT_EQ(one.offset, other.offset);
  }
  EXPECT_GT(edges, 500);
}

TEST(PointTriangle, PastTheTipOfANeedleTheTipIsClosest) {
  // Both edge lines pass within rounding of points past the tip; the plane does too.
  const TriangleShape needle = shape({0, 0, 0}, {1, 0, 0}, {1, 0x1p-50, 0});
  EXPECT_EQ(distance({-0.25, 0, 0}, needle), 0.25);
  EXPECT_EQ(distance({-0.25, -0x1p-54, 0}, needle), 0.25);
  EXPECT_EQ(distance({-3, 0, 4}, needle), 5);
}

TEST(PointTriangle, ATriangleOfNoAreaIsItsLongestEdge) {
  const TriangleShape line = shape({0, 0, 0}, {4, 0, 0}, {1, 0, 0});
  EXPECT_EQ(distance({2, 3, 0}, line), 3);
  EXPECT_EQ(distance({2, 0, 0}, line), 0);
  const TriangleShape dot = shape({1, 1, 1}, {1, 1, 1}, {1, 1, 1});
  EXPECT_EQ(distance({1, 4, 5}, dot), 5);
}

TEST(PointTriangle, BarycentricsRebuildTheFoot) {
  test::Random random(7);
  const Box box{{-1, -1, -1}, {1, 1, 1}};
  for (int i = 0; i < 5000; ++i) {
    const TriangleShape t = shape(random.in(box), random.in(box), random.in(box));
    const Vec3 p = random.in(box);
    const Foot foot = measure(p, t);
    const std::array<double, 3> w = barycentric(p, t, foot);
    EXPECT_NEAR(w[0] + w[1] + w[2], 1, 1e-15);
    EXPECT_GE(std::min({w[0], w[1], w[2]}), 0);
    const double x = w[0] * t.vertices[0].x + w[1] * t.vertices[1].x + w[2] * t.vertices[2].x;
    EXPECT_NEAR(x, p.x - foot.offset[0].hi, 1e-14);
  }
}

}  // namespace
}  // namespace cdfr
