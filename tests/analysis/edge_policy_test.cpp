// Design edges: who is held by one, what each policy makes of it, and that none passes for a thin wall.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "analysis/shapes.h"
#include "analysis/smooth_regions.h"
#include "cdfr/analysis/thickness.h"
#include "field/field_data.h"
#include "support/meshes.h"

namespace cdfr {
namespace {

ThicknessOptions sampled(double spacing, EdgePolicy edges) {
  ThicknessOptions options;
  options.at = SampleAt::spacing;
  options.spacing = spacing;
  options.edges = edges;
  return options;
}

const Box plate{{0, 0, 0}, {12, 10, 1}};

/// How far a sample on the plate's large faces is from their border.
double from_border(const Vec3& p) { return std::min({p.x, plate.hi.x - p.x, p.y, plate.hi.y - p.y}); }

TEST(EdgePolicy, SphereGivesTheBallAndMarksIt) {
  const Field field = Field::build(test::box_mesh(plate).view()).value();
  const Thickness found = thickness(field, sampled(0.23, EdgePolicy::sphere)).value();
  std::size_t at_edge = 0;
  for (const ThicknessSample& sample : found.samples) {
    if (std::fabs(sample.normal.z) < 0.5) continue;
    const double border = from_border(sample.position);
    EXPECT_NEAR(sample.thickness, std::min(1.0, 2 * border), 1e-6);
    if (std::fabs(border - 0.5) > 1e-6) {
      EXPECT_EQ(sample.at_edge, border < 0.5);
    }
    at_edge += sample.at_edge;
  }
  EXPECT_GT(at_edge, 100U);
  EXPECT_EQ(found.report.regions, 6U);
  EXPECT_LT(found.report.min, 0.3);
  ASSERT_FALSE(found.report.places.empty());
  EXPECT_TRUE(found.report.places.front().is_wall());
  EXPECT_NEAR(found.report.places.front().thickness, 1, 1e-6) << "no edge is a thin wall";
}

TEST(EdgePolicy, ExtrapolateTakesTheNearestOfTheRegion) {
  const Field field = Field::build(test::box_mesh(plate).view()).value();
  const Thickness found = thickness(field, sampled(0.23, EdgePolicy::extrapolate)).value();
  std::size_t narrow = 0;
  for (const ThicknessSample& sample : found.samples) {
    if (std::fabs(sample.normal.z) > 0.5) {
      EXPECT_NEAR(sample.thickness, 1, 1e-6);
    } else {
      // A narrow side has no sample that no edge holds, so the ball's own value stands.
      EXPECT_TRUE(sample.at_edge);
      EXPECT_LE(sample.thickness, 1 + 1e-6);
      ++narrow;
    }
  }
  EXPECT_GT(narrow, 0U);
  EXPECT_GT(found.report.extrapolated, 100U);
}

TEST(EdgePolicy, SkipLeavesThemOut) {
  const Field field = Field::build(test::box_mesh(plate).view()).value();
  const Thickness all = thickness(field, sampled(0.23, EdgePolicy::sphere)).value();
  const Thickness found = thickness(field, sampled(0.23, EdgePolicy::skip)).value();
  EXPECT_EQ(found.samples.size() + found.report.skipped, all.samples.size());
  EXPECT_EQ(found.report.skipped, all.report.at_edge);
  for (const ThicknessSample& sample : found.samples) {
    EXPECT_FALSE(sample.at_edge);
    EXPECT_NEAR(sample.thickness, 1, 1e-6);
  }
  EXPECT_EQ(found.report.at_edge, 0U);
  EXPECT_NEAR(found.report.min, found.report.max, 1e-6);
}

TEST(EdgePolicy, VerticesOnADesignEdgeAreAtIt) {
  const Field field = Field::build(test::box_mesh(plate).view()).value();
  ThicknessOptions options;
  options.at = SampleAt::vertices;
  const Thickness found = thickness(field, options).value();
  ASSERT_EQ(found.samples.size(), 8U);
  for (const ThicknessSample& sample : found.samples) {
    EXPECT_TRUE(sample.at_edge);
    EXPECT_LT(sample.thickness, 1e-6);
  }
  options.edges = EdgePolicy::skip;
  const Thickness none = thickness(field, options).value();
  EXPECT_TRUE(none.samples.empty());
  EXPECT_TRUE(std::isnan(none.report.min));
  EXPECT_TRUE(none.report.places.empty());
}

/// A fillet joins its neighbours to one region, a sharp corner parts them.
TEST(SmoothRegions, ArePartedByDesignEdgesAlone) {
  const auto regions_of = [](const Mesh& mesh, double sharp, Bend bend) {
    const Field field = Field::build(mesh.view()).value();
    const TriangleStore& triangles = field.data().triangles;
    return SmoothRegions(triangles, TriangleEdges(triangles), sharp, bend);
  };
  EXPECT_EQ(regions_of(test::icosphere(2), 30, Bend::convex).count(), 1U);
  EXPECT_EQ(regions_of(test::icosphere(0), 30, Bend::convex).count(), 20U);
  EXPECT_EQ(regions_of(test::tube(0.02).mesh, 30, Bend::convex).count(), 4U);
  // The floor of the stepped plate adjoins no riser, and riser and lower face meet at a concave edge.
  const Mesh stepped = test::stepped_plate(0).mesh;
  const SmoothRegions convex = regions_of(stepped, 30, Bend::convex);
  const SmoothRegions concave = regions_of(stepped, 30, Bend::concave);
  EXPECT_EQ(convex.count(), 8U);
  std::size_t convex_pairs = 0, concave_pairs = 0;
  for (std::uint32_t a = 0; a < 8; ++a) {
    for (std::uint32_t b = 0; b < a; ++b) {
      convex_pairs += convex.adjoin(a, b);
      concave_pairs += concave.adjoin(a, b);
      EXPECT_EQ(convex.adjoin(a, b), convex.adjoin(b, a));
    }
  }
  EXPECT_EQ(convex_pairs, 17U);
  EXPECT_EQ(concave_pairs, 1U);
}

}  // namespace
}  // namespace cdfr
