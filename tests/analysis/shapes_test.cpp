// The shapes themselves: their meshes are what they say, and their closed forms agree with plain sampling.
#include "analysis/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "cdfr/field/field.h"
#include "cdfr/mesh/audit.h"
#include "support/random.h"

namespace cdfr {
namespace {

constexpr double rounding = 1e-9;

Vec3 inward(const test::Place& place, double way) {
  const Vec3 &p = place.point, &n = place.normal;
  return {p.x - way * n.x, p.y - way * n.y, p.z - way * n.z};
}

class Shapes : public testing::TestWithParam<std::size_t> {
 protected:
  static constexpr double chord = 0.01;
  const test::Shape shape = test::shapes(chord)[GetParam()];
};
INSTANTIATE_TEST_SUITE_P(All, Shapes, testing::Range(std::size_t{0}, test::shapes(0.05).size()));

TEST_P(Shapes, AreClosedOutwardAndEmbeddedWithTheirVolume) {
  SCOPED_TRACE(shape.name);
  const MeshReport report = audit(shape.mesh.view()).value();
  EXPECT_TRUE(report.embedded()) << sign_reason(report);
  EXPECT_EQ(report.components, 1U);
  EXPECT_EQ(report.degenerate_triangles, 0U);
  EXPECT_NEAR(report.volume, shape.volume, shape.area * shape.error + rounding);
  EXPECT_NEAR(report.area, shape.area, shape.area * 0.02 + rounding);
  if (shape.error == 0) {
    EXPECT_NEAR(report.area, shape.area, rounding);
  }
}

TEST_P(Shapes, DepthsOfMeshAndSolidDifferByNoMoreThanTheError) {
  SCOPED_TRACE(shape.name);
  const Field field = Field::build(shape.mesh.view()).value();
  test::Random random(GetParam() + 1);
  for (int i = 0; i < 20000; ++i) {
    const Vec3 p = random.in(field.bounds());
    const double depth = shape.depth(p), of_mesh = -field.distance(p);
    if (depth <= 0) {
      ASSERT_LE(of_mesh, shape.error + rounding);
    } else {
      ASSERT_NEAR(of_mesh, depth, shape.error + rounding) << p.x << ' ' << p.y << ' ' << p.z;
    }
  }
}

TEST_P(Shapes, LevelsHaveTheVolumeThatSamplingFinds) {
  SCOPED_TRACE(shape.name);
  const Box box = audit(shape.mesh.view()).value().box;
  const double all = (box.hi.x - box.lo.x) * (box.hi.y - box.lo.y) * (box.hi.z - box.lo.z);
  constexpr int count = 400000;
  std::vector<double> depths;
  test::Random random(GetParam() + 100);
  for (int i = 0; i < count; ++i) depths.push_back(shape.depth(random.in(box)));
  for (const test::DeepLevel& level : shape.levels) {
    double volume = 0;
    for (const test::Region& region : level.regions) {
      EXPECT_LE(region.low, region.volume);
      EXPECT_LE(region.volume, region.high);
      EXPECT_GT(region.low, 0);
      volume += region.volume;
    }
    const double share =
        static_cast<double>(std::ranges::count_if(depths, [&](double d) { return d > level.depth; })) / count;
    const double deviation = std::sqrt(volume / all / count);
    EXPECT_NEAR(share, volume / all, 5 * deviation) << level.depth;
  }
}

TEST_P(Shapes, BallsAndNecksAreAsDeepAsTheySay) {
  SCOPED_TRACE(shape.name);
  for (const test::InscribedBall& ball : shape.balls) {
    EXPECT_NEAR(shape.depth(ball.centre), ball.radius, rounding);
    EXPECT_LE(ball.radius, shape.balls.front().radius);
  }
  for (const test::Neck& neck : shape.necks) EXPECT_NEAR(shape.depth(neck.centre), neck.radius, rounding);
  const Box box = audit(shape.mesh.view()).value().box;
  test::Random random(GetParam() + 200);
  for (int i = 0; i < 100000; ++i)
    ASSERT_LE(shape.depth(random.in(box)), shape.balls.front().radius + rounding);
}

TEST_P(Shapes, PlacesTouchTheirBallAndTheirRay) {
  SCOPED_TRACE(shape.name);
  ASSERT_FALSE(shape.places.empty());
  for (const test::Place& place : shape.places) {
    SCOPED_TRACE(testing::Message() << place.point.x << ' ' << place.point.y << ' ' << place.point.z);
    const double r = place.sphere / 2;
    EXPECT_NEAR(shape.depth(place.point), 0, rounding);
    EXPECT_NEAR(shape.depth(inward(place, r)), r, rounding);
    EXPECT_LT(shape.depth(inward(place, 1.001 * r)), 1.001 * r - 1e-4 * r);
    EXPECT_NEAR(shape.depth(inward(place, place.ray)), 0, rounding);
    for (int i = 1; i < 1000; ++i) ASSERT_GT(shape.depth(inward(place, place.ray * i / 1000)), 0);
  }
}

}  // namespace
}  // namespace cdfr
