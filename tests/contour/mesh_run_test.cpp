// Threads, cancel, and what is refused by name.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "contour/surface.h"
#include "support/meshes.h"
#include "support/same.h"
#include "support/ticks.h"

namespace cdfr {
namespace {

Field box_field(Sign sign = Sign::automatic) {
  BuildOptions options;
  options.sign = sign;
  return Field::build(test::box_mesh({{0, 0, 0}, {1, 0.8, 0.5}}).view(), options).value();
}

TEST(MeshRun, SameBytesForAnyThreads) {
  const Field field = Field::build(test::sphere_mesh(3).view()).value();
  for (const double distance : {-0.3, 0.4}) {
    cdfr::Run run;
    run.threads = 1;
    const ContourMesh expected = contour_mesh(field, distance, {0.01}, run).value();
    ASSERT_GT(expected.mesh.triangles.size(), 1000U);
    for (const unsigned threads : {2U, 5U}) {
      run.threads = threads;
      const ContourMesh again = contour_mesh(field, distance, {0.01}, run).value();
      ASSERT_EQ(again.mesh.triangles, expected.mesh.triangles);
      ASSERT_EQ(again.mesh.vertices.size(), expected.mesh.vertices.size());
      for (std::size_t i = 0; i < expected.mesh.vertices.size(); ++i)
        ASSERT_TRUE(test::same_bits(again.mesh.vertices[i], expected.mesh.vertices[i])) << i;
      EXPECT_EQ(again.report.evaluations, expected.report.evaluations);
    }
  }
}

TEST(MeshRun, TickCancelsEarlyAndLate) {
  const Field field = box_field();
  for (const double distance : {-0.1, 0.0, 0.1}) {
    for (const int after : {0, 1, 5, 20}) {
      if (distance == 0 && after > 0) continue;
      test::Ticks ticks;
      ticks.left = after;
      cdfr::Run run;
      run.threads = 2;
      run.tick = test::count_down;
      run.context = &ticks;
      const auto result = contour_mesh(field, distance, {0.002}, run);
      ASSERT_FALSE(result) << distance << ' ' << after;
      EXPECT_EQ(result.error().code, Code::cancelled);
    }
  }
}

TEST(MeshRun, TickIsToldTheShareDone) {
  test::Ticks ticks;
  ticks.left = 1 << 30;
  cdfr::Run run;
  run.tick = test::count_down;
  run.context = &ticks;
  ASSERT_TRUE(contour_mesh(box_field(), 0.1, {0.02}, run));
  EXPECT_LT(ticks.left, 1 << 30);
  EXPECT_FALSE(ticks.disorder);
}

Code refused(const Field& field, double distance, double tolerance) {
  const auto result = contour_mesh(field, distance, {tolerance});
  EXPECT_FALSE(result);
  if (result) return Code{};
  EXPECT_FALSE(result.error().text.empty());
  return result.error().code;
}

TEST(MeshOptions, AreRefusedByName) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const Field field = box_field();
  for (const double distance : {nan, infinity, -infinity})
    EXPECT_EQ(refused(field, distance, 0.1), Code::bad_option);
  for (const double tolerance : {nan, infinity, -infinity, -0.1, -1e-300, 1e-300, 0x1p-20})
    EXPECT_EQ(refused(field, -0.1, tolerance), Code::bad_option) << tolerance;
  EXPECT_EQ(refused(field, 1e9, 0.1), Code::bad_option);
  EXPECT_EQ(refused(field, 1e300, 0.1), Code::bad_option);
}

TEST(MeshOptions, NoToleranceIsAThousandthOfTheLongestSide) {
  const ContourMesh contour = test::surface_of(box_field(), -0.1, 0);
  EXPECT_EQ(contour.report.tolerance, 1.0 / 1000);
}

TEST(MeshOptions, LargeTolerancesAreTaken) {
  for (const double tolerance : {0.3, 1.0, 7.0}) {
    test::surface_of(box_field(), 0.2, tolerance);
    test::surface_of(box_field(), -0.2, tolerance);
  }
}

TEST(MeshOptions, AnUnsignedFieldHasBothSides) {
  const Field field = box_field(Sign::none);
  EXPECT_EQ(refused(field, -0.1, 0.1), Code::not_closed);
  EXPECT_EQ(refused(field, 0, 0.1), Code::not_closed);
  const ContourMesh contour = test::surface_of(field, 0.1, 0.01);
  const double outer = test::volume_of(test::surface_of(box_field(), 0.1, 0.01).mesh);
  const double inner = test::volume_of(test::surface_of(box_field(), -0.1, 0.01).mesh);
  EXPECT_NEAR(test::volume_of(contour.mesh), outer - inner, 0.01);
}

TEST(MeshOptions, AnOpenMeshIsRefusedByNameUnlessUnsigned) {
  Mesh mesh = test::box_mesh({{0, 0, 0}, {1, 0.8, 0.5}});
  mesh.triangles.resize(10);
  EXPECT_EQ(refused(Field::build(mesh.view()).value(), 0.1, 0.02), Code::not_closed);
  BuildOptions options;
  options.sign = Sign::none;
  const Field field = Field::build(mesh.view(), options).value();
  const ContourMesh contour = test::surface_of(field, 0.1, 0.01);
  EXPECT_EQ(contour.report.loose, 0U);
  EXPECT_LE(test::largest_excess(field, contour.mesh, 0.1, 20000), 0.01);
  EXPECT_LE(test::largest_gap(field, contour.mesh, 0.1, 0.04), 0.01);
}

}  // namespace
}  // namespace cdfr
