// The largest ball: its bracket against brute-force distances, and closed forms.
#include "analysis/largest_ball.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <vector>

#include "analysis/shapes.h"
#include "cdfr/analysis/thickness.h"
#include "cdfr/mesh/read.h"
#include "cdfr/parts/part.h"
#include "support/joined.h"
#include "support/meshes.h"

namespace cdfr {
namespace {

Vec3 ahead(const Vec3& p, const Vec3& u, double way) {
  return {p.x + way * u.x, p.y + way * u.y, p.z + way * u.z};
}
Vec3 negative(const Vec3& v) { return {-v.x, -v.y, -v.z}; }
double apart(const Vec3& a, const Vec3& b) { return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z); }

/// r - depth: what must not exceed D.
double excess(const BruteForce& brute, const ThicknessSample& sample, double radius) {
  return radius + brute.closest(ahead(sample.position, negative(sample.normal), radius)).distance;
}

/// Every `stride`-th sample's ends are feasible and not, and its opposite point says why.
void expect_brackets(const Mesh& mesh, ThicknessOptions options, std::size_t stride = 1) {
  const Field field = Field::build(mesh.view()).value();
  const BruteForce brute = BruteForce::over(mesh.view()).value();
  const Thickness found = thickness(field, options).value();
  const double slack = 2 * found.report.rounding;
  ASSERT_FALSE(found.samples.empty());
  for (std::size_t i = 0; i < found.samples.size(); i += stride) {
    const ThicknessSample& sample = found.samples[i];
    SCOPED_TRACE(i);
    ASSERT_GE(sample.thickness, 0);
    ASSERT_LE(sample.error, found.report.error);
    const double facet = sample.facet, low = sample.thickness / 2,
                 high = (sample.thickness + sample.error) / 2;
    ASSERT_LE(excess(brute, sample, low), facet + slack);
    ASSERT_GT(excess(brute, sample, high + slack), facet - slack);
    const Vec3 centre = ahead(sample.position, negative(sample.normal), high);
    ASSERT_LE(std::fabs(brute.closest(sample.opposite_point).distance), slack);
    // Where the centre is inside, the opposite point is what bounds it.
    if (brute.closest(centre).distance < 0) {
      ASSERT_LE(apart(centre, sample.opposite_point), high - facet + 1e-6 + slack);
    }
  }
}

TEST(LargestBall, HasABracketThatBruteForceConfirms) {
  for (const SampleAt at : {SampleAt::faces, SampleAt::vertices}) {
    for (const double facet : {0.0, 0.02, -1.0}) {
      ThicknessOptions options;
      options.at = at;
      options.facet = facet;
      expect_brackets(test::box_mesh({{0, 0, 0}, {3, 4, 5}}), options);
      expect_brackets(test::icosphere(2), options);
      expect_brackets(make_part("six-star").value(), options);
      expect_brackets(make_part("one-tooth").value(), options);
    }
  }
}

TEST(LargestBall, HasItAtACoarseErrorAndAtASpacing) {
  ThicknessOptions options;
  options.at = SampleAt::spacing;
  options.spacing = 0.7;
  options.error = 0.01;
  expect_brackets(test::box_mesh({{0, 0, 0}, {3, 4, 5}}), options);
  expect_brackets(test::sphere_mesh(2), options);
}

TEST(LargestBall, HasItOnARealPart) {
  const std::filesystem::path path = std::filesystem::path(CDFR_SHARED_DATA) / "public/openscad/CSG.stl";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is missing";
  const Mesh mesh = read_mesh(path).value();
  for (const double facet : {0.0, -1.0}) {
    ThicknessOptions options;
    options.facet = facet;
    expect_brackets(mesh, options, 10);
  }
}

/// A wall thinner than the facet tolerance is (D + t) / 2 thick.
TEST(LargestBall, OfAWallThinnerThanTheFacetTolerance) {
  const Field field = Field::build(test::box_mesh({{0, 0, 0}, {100, 100, 0.5}}).view()).value();
  ThicknessOptions options;
  options.facet = 2;
  const Thickness found = thickness(field, options).value();
  for (const ThicknessSample& sample : found.samples) {
    if (std::fabs(sample.normal.z) == 1) {
      EXPECT_NEAR(sample.thickness, 2.5, 1e-6);
    }
  }
}

/// The largest radius within that tolerance in the solid, by halving. All of it is below the diameter, where
/// the centre has not left the solid.
double radius_in_solid(const test::Shape& shape, const test::Place& place, double facet) {
  double low = 0, high = 0.9 * place.sphere;
  for (int i = 0; i < 100; ++i) {
    const double r = (low + high) / 2;
    const double depth = shape.depth(ahead(place.point, negative(place.normal), r));
    (depth > 0 && r - depth <= facet + 1e-12 ? low : high) = r;
  }
  return low;
}

class LargestBallOfShape : public testing::TestWithParam<std::size_t> {};
INSTANTIATE_TEST_SUITE_P(All, LargestBallOfShape, testing::Range(std::size_t{0}, test::shapes(0.1).size()));

/// On the solid itself the answer is Place::sphere; what the mesh may make of it shapes.h says.
TEST_P(LargestBallOfShape, HasItsClosedForm) {
  const test::Shape shape = test::shapes(0.01)[GetParam()];
  SCOPED_TRACE(shape.name);
  const Field field = Field::build(shape.mesh.view()).value();
  const cdfr::Run run;
  for (const double facet : {shape.error, 2 * shape.error + 0.01}) {
    for (const test::Place& place : shape.places) {
      const WallPoint point{place.point, negative(place.normal), 0, facet};
      const BallOptions options{false, 1e-9, 100, ball_rounding(field.data(), 100)};
      MeasuredWall wall;
      Progress progress(run);
      EXPECT_GT(largest_balls(field.data(), {&point, 1}, options, {&wall, 1}, progress), 0U);
      EXPECT_LE(wall.error, 2.1e-9);
      EXPECT_LE(wall.thickness, 2 * radius_in_solid(shape, place, facet + shape.error) + 1e-8);
      EXPECT_GE(wall.thickness, 2 * radius_in_solid(shape, place, facet - shape.error) - 1e-8);
      if (facet == 0) {
        EXPECT_NEAR(wall.thickness, place.sphere, 1e-8);
      }
    }
  }
}

TEST(LargestBall, OfAGapBetweenTwoBoxes) {
  const Mesh mesh =
      test::joined(test::box_mesh({{0, 0, 0}, {10, 10, 1}}), test::box_mesh({{0, 0, 1.25}, {10, 10, 2}}));
  const Field field = Field::build(mesh.view()).value();
  ThicknessOptions options;
  options.clearance = true;
  options.largest = 3;
  const Thickness found = thickness(field, options).value();
  std::size_t met = 0;
  for (const ThicknessSample& sample : found.samples) {
    const bool in_gap = (sample.position.z == 1 && sample.normal.z == 1) ||
                        (sample.position.z == 1.25 && sample.normal.z == -1);
    EXPECT_EQ(in_gap, !std::isnan(sample.thickness));
    if (!in_gap) continue;
    ++met;
    EXPECT_NEAR(sample.thickness, 0.25, 1e-7);
    EXPECT_NEAR(sample.opposite_point.z, 2.25 - sample.position.z, 1e-9);
  }
  EXPECT_EQ(met, 4U);
  EXPECT_EQ(found.report.unmet, 20U);
}

}  // namespace
}  // namespace cdfr
