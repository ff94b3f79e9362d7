// Statistics, histogram and thinnest places.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "analysis/shapes.h"
#include "analysis/thickness_statistics.h"
#include "cdfr/analysis/thickness.h"
#include "support/meshes.h"
#include "support/random.h"

namespace cdfr {
namespace {

TEST(ThicknessReport, QuantilesAreByWeight) {
  const std::vector<WeightedValue> values{{1, 1}, {2, 8}, {5, 1}};
  EXPECT_EQ(quantile(values, 0), 1);
  EXPECT_EQ(quantile(values, 0.1), 1);
  EXPECT_EQ(quantile(values, 0.11), 2);
  EXPECT_EQ(quantile(values, 0.9), 2);
  EXPECT_EQ(quantile(values, 0.95), 5);
  EXPECT_EQ(quantile(values, 1), 5);
  EXPECT_TRUE(std::isnan(quantile({}, 0.5)));
}

TEST(ThicknessReport, AWallAtItsLimitIsNotThin) {
  const Field field = Field::build(test::plate(0).mesh.view()).value();
  ThicknessOptions options;
  options.at = SampleAt::spacing;
  options.spacing = 1;
  options.edges = EdgePolicy::skip;
  options.thinner_than = 2;
  EXPECT_EQ(thickness(field, options).value().report.thin_area, 0);
  options.thinner_than = 2.001;
  EXPECT_GT(thickness(field, options).value().report.thin_area, 0);
}

TEST(ThicknessReport, AreasAddUp) {
  const test::Shape shape = test::stepped_plate(0);
  const Field field = Field::build(shape.mesh.view()).value();
  for (const SampleAt at : {SampleAt::faces, SampleAt::vertices, SampleAt::spacing}) {
    ThicknessOptions options;
    options.at = at;
    options.spacing = 0.5;
    options.bins = 7;
    const ThicknessReport report = thickness(field, options).value().report;
    EXPECT_NEAR(report.area, shape.area, 1e-9);
    ASSERT_EQ(report.histogram.size(), 7U);
    EXPECT_NEAR(std::accumulate(report.histogram.begin(), report.histogram.end(), 0.0), shape.area, 1e-9);
    EXPECT_LE(report.min, report.p1);
    EXPECT_LE(report.p1, report.p50);
    EXPECT_LE(report.p50, report.p99);
    EXPECT_LE(report.p99, report.max);
    EXPECT_GE(report.mean, report.min);
    EXPECT_LE(report.mean, report.max);
    EXPECT_EQ(report.unmet, 0U);
  }
}

/// Walls of 2 and 5: the thin one is a place on both of its sides, and thin is strictly so.
TEST(ThicknessReport, ThinPlacesOfASteppedPlate) {
  const test::Shape shape = test::stepped_plate(0);
  const Field field = Field::build(shape.mesh.view()).value();
  ThicknessOptions options;
  options.at = SampleAt::spacing;
  options.spacing = 0.25;
  options.edges = EdgePolicy::skip;
  options.thinner_than = 2.01;
  const ThicknessReport report = thickness(field, options).value().report;
  ASSERT_EQ(report.place_count, 2U);
  for (const ThinPlace& place : report.places) {
    EXPECT_NEAR(place.thickness, 2, 1e-6);
    EXPECT_LE(place.position.x, 8.5);
    EXPECT_TRUE(place.position.y == 0 || place.position.y == 2);
    EXPECT_FALSE(place.at_edge);
    EXPECT_GT(place.samples, 100U);
  }
  EXPECT_NEAR(report.places[0].area + report.places[1].area, report.thin_area, 1e-9);
  EXPECT_EQ(report.thin_area, report.thin_wall_area);
  options.thinner_than = report.min;
  const ThicknessReport at_limit = thickness(field, options).value().report;
  EXPECT_EQ(at_limit.thin_area, 0);
  EXPECT_TRUE(at_limit.places.empty());
}

/// Slivers too.
TEST(ThicknessSamples, AreNowhereFartherThanTheSpacing) {
  for (const double width : {1.0, 0.3, 0.05}) {
    Mesh mesh;
    mesh.vertices = {{0, 0, 0}, {0, width, 0}, {0, 0, width}, {10, 0, 0}};
    mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
    const Field field = Field::build(mesh.view()).value();
    ThicknessOptions options;
    options.at = SampleAt::spacing;
    options.spacing = 0.1;
    const Thickness found = thickness(field, options).value();
    double area = 0;
    for (const ThicknessSample& sample : found.samples) area += sample.area;
    EXPECT_NEAR(area, field.report().area, 1e-9);
    test::Random random(3);
    for (int i = 0; i < 300; ++i) {
      const auto& t = mesh.triangles[random.below(4)];
      double a = random.between(0, 1), b = random.between(0, 1);
      if (a + b > 1) a = 1 - a, b = 1 - b;
      const Vec3 &p = mesh.vertices[t[0]], &q = mesh.vertices[t[1]], &r = mesh.vertices[t[2]];
      const Vec3 x{p.x + a * (q.x - p.x) + b * (r.x - p.x), p.y + a * (q.y - p.y) + b * (r.y - p.y),
                   p.z + a * (q.z - p.z) + b * (r.z - p.z)};
      double nearest = INFINITY;
      for (const ThicknessSample& s : found.samples)
        nearest = std::min(nearest, std::hypot(x.x - s.position.x, x.y - s.position.y, x.z - s.position.z));
      ASSERT_LE(nearest, options.spacing);
    }
    EXPECT_LT(static_cast<double>(found.samples.size()), 20 * (area / 0.01 + 40 / 0.1));
  }
}

/// A block with rounded edges: the ball at a fillet is the fillet's, and no thin wall.
TEST(ThicknessReport, AFilletIsNoThinWall) {
  const Field field = Field::build(test::l_junction(0.01).mesh.view()).value();
  ThicknessOptions options;
  options.at = SampleAt::spacing;
  options.spacing = 0.25;
  const Thickness found = thickness(field, options).value();
  ASSERT_FALSE(found.report.places.empty());
  EXPECT_TRUE(found.report.places.front().is_wall());
  EXPECT_NEAR(found.report.places.front().thickness, 2, 0.05);
  EXPECT_LT(found.report.min, 1.6);
  bool walls_over = false;
  for (const ThinPlace& place : found.report.places) {
    walls_over |= !place.is_wall();
    EXPECT_EQ(place.is_wall(), !walls_over) << "walls come first";
  }
}

TEST(ThicknessReport, ListsNoMorePlacesThanAsked) {
  const Field field = Field::build(test::box_mesh({{0, 0, 0}, {12, 10, 1}}).view()).value();
  ThicknessOptions options;
  options.places = 0;
  options.thinner_than = 100;
  const ThicknessReport report = thickness(field, options).value().report;
  EXPECT_TRUE(report.places.empty());
  EXPECT_GT(report.place_count, 0U);
}

}  // namespace
}  // namespace cdfr
