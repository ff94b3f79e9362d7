// The estimated chord error, and what thickness makes of it on a sphere.
#include "analysis/facet_estimate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "analysis/shapes.h"
#include "cdfr/analysis/thickness.h"
#include "support/meshes.h"

namespace cdfr {
namespace {

FacetEstimate estimate_of(const Mesh& mesh, double sharp = 30) {
  const Field field = Field::build(mesh.view()).value();
  return estimate_facets(field.data(), TriangleEdges(field.data().triangles), sharp).estimate;
}

TEST(FacetEstimate, OfPlaneFacesIsNothing) {
  const FacetEstimate estimate = estimate_of(test::box_mesh({{0, 0, 0}, {3, 4, 5}}));
  EXPECT_EQ(estimate.quantile, 0);
  EXPECT_EQ(estimate.curved_triangles, 0U);
}

/// The prism of `sides` sides in a cylinder of radius 1.
Mesh prism(std::uint32_t sides) {
  Mesh mesh;
  for (std::uint32_t i = 0; i < sides; ++i) {
    const double angle = 2 * std::numbers::pi * i / sides;
    for (const double z : {0.0, 3.0}) mesh.vertices.push_back({std::cos(angle), std::sin(angle), z});
    const std::uint32_t a = 2 * i, b = 2 * ((i + 1) % sides);
    mesh.triangles.insert(mesh.triangles.end(), {{a, b, b + 1}, {a, b + 1, a + 1}});
    if (i > 1)
      mesh.triangles.insert(mesh.triangles.end(), {{0, 2 * i, 2 * i - 2}, {1, 2 * i - 1, 2 * i + 1}});
  }
  return mesh;
}

TEST(FacetEstimate, OfAPrismRoundACylinderIsItsSagitta) {
  for (const std::uint32_t sides : {16U, 60U, 200U}) {
    const FacetEstimate estimate = estimate_of(prism(sides));
    const double sagitta = 1 - std::cos(std::numbers::pi / sides);
    EXPECT_NEAR(estimate.quantile, sagitta, 1e-9);
    EXPECT_NEAR(estimate.largest, sagitta, 1e-9);
    EXPECT_EQ(estimate.curved_triangles, 2 * sides);
  }
  EXPECT_EQ(estimate_of(prism(16), 20).curved_triangles, 0U) << "22.5 degrees are a design edge there";
}

/// Large plane faces that go over into a fillet have no chord error of their own.
TEST(FacetEstimate, OfAFilletIsNotThatOfThePlanesBeside) {
  for (const test::Shape& shape : {test::l_junction(0.01), test::t_junction(0.01)}) {
    const FacetEstimate estimate = estimate_of(shape.mesh);
    EXPECT_GT(estimate.quantile, shape.error / 3) << shape.name;
    EXPECT_LT(estimate.largest, 2 * shape.error) << shape.name;
  }
}

/// The round sides of a tube have a tolerance, its plane ends none.
TEST(FacetEstimate, IsEachTrianglesOwn) {
  const test::Shape tube = test::tube(0.01);
  const Field field = Field::build(tube.mesh.view()).value();
  ThicknessOptions options;
  options.at = SampleAt::spacing;
  options.spacing = 0.5;
  const Thickness found = thickness(field, options).value();
  std::size_t plane = 0, curved = 0;
  for (const ThicknessSample& sample : found.samples) {
    const bool at_end = std::fabs(sample.normal.z) > 0.5;
    EXPECT_EQ(sample.facet == 0, at_end);
    ++(at_end ? plane : curved);
  }
  EXPECT_GT(plane, 0U);
  EXPECT_GT(curved, 0U);
  EXPECT_GT(found.report.facet, tube.error / 10);
}

TEST(FacetEstimate, GivesASphereItsDiameter) {
  const Field field = Field::build(test::icosphere(3).view()).value();
  for (const SampleAt at : {SampleAt::faces, SampleAt::vertices}) {
    ThicknessOptions options;
    options.at = at;
    const Thickness found = thickness(field, options).value();
    ASSERT_EQ(found.samples.size(), at == SampleAt::faces ? 1280U : 642U);
    EXPECT_EQ(found.report.at_edge, 0U);
    for (const ThicknessSample& sample : found.samples) ASSERT_NEAR(sample.thickness, 2, 0.04);
    EXPECT_LT(found.report.facet, 0.01);
    options.facet = 0;
    const Thickness exact = thickness(field, options).value();
    for (const ThicknessSample& sample : exact.samples)
      ASSERT_LT(sample.thickness, at == SampleAt::vertices ? 1e-6 : 2.0);
  }
}

}  // namespace
}  // namespace cdfr
