// Tolerances, signs, and what is refused by name.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <tuple>

#include "contour/case.h"
#include "contour/coverage.h"
#include "support/meshes.h"

namespace cdfr {
namespace {

using test::Case;
using test::Contour;

const Box unit_box{{0, 0, 0}, {1, 1, 1}};

Code refused(const Field& field, double distance, double tolerance) {
  const auto result = contour_points(field, distance, {tolerance});
  EXPECT_FALSE(result);
  if (result) return Code{};
  EXPECT_FALSE(result.error().text.empty());
  return result.error().code;
}

TEST(ContourOptions, AreRefusedByName) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const Field cube = Field::build(test::box_mesh(unit_box).view()).value();
  for (const double distance : {nan, infinity, -infinity})
    EXPECT_EQ(refused(cube, distance, 0.1), Code::bad_option);
  for (const double tolerance : {nan, infinity, -infinity, -0.1, -1e-300, 1e-300, 0x1p-41}) {
    EXPECT_EQ(refused(cube, -0.1, tolerance), Code::bad_option) << tolerance;
  }
  EXPECT_EQ(refused(cube, nan, nan), Code::bad_option);
}

TEST(ContourOptions, SmallestToleranceIsTaken) {
  const Field cube = Field::build(test::box_mesh(unit_box).view()).value();
  EXPECT_TRUE(contour_points(cube, -0.75, {0x1p-40}));
}

TEST(ContourOptions, AnUnsignedFieldHasAnOutsideOnly) {
  Mesh mesh = test::box_mesh(unit_box);
  mesh.triangles.resize(10);
  BuildOptions options;
  options.sign = Sign::none;
  const Case open(std::move(mesh), options);
  EXPECT_EQ(refused(open.field, -0.1, 0.1), Code::not_closed);
  EXPECT_EQ(refused(open.field, -1e-300, 0.1), Code::not_closed);
  for (const double distance : {0.0, 0.1, 0.3}) {
    const Contour contour = test::contour_of(open.field, distance, 0.08);
    EXPECT_EQ(contour.report.undecided, 0U);
    test::expect_true_points(open, contour, 2);
    test::expect_covered(contour, test::true_contour(open, distance, test::scaled(unit_box, 2.5), 5000, 31));
  }
}

TEST(ContourOptions, AClosedMeshWithoutSignHasItsContourOnBothSides) {
  BuildOptions options;
  options.sign = Sign::none;
  const Case both(test::box_mesh(unit_box), options);
  const Contour contour = test::contour_of(both.field, 0.3, 0.08);
  test::expect_true_points(both, contour, 2);
  test::expect_covered(contour, test::true_contour(both, 0.3, unit_box, 3000, 32));
  test::expect_covered(contour, test::true_contour(both, 0.3, test::scaled(unit_box, 2.5), 3000, 33));
}

TEST(ContourOptions, NoToleranceIsAThousandthOfTheLongestSide) {
  const Field plate = Field::build(test::box_mesh({{0, 0, 0}, {1, 0.02, 0.02}}).view()).value();
  const auto taken = contour_points(plate, -0.005).value();
  const auto given = contour_points(plate, -0.005, {1.0 / 1000}).value();
  ASSERT_EQ(taken.size(), given.size());
  ASSERT_FALSE(taken.empty());
  for (std::size_t i = 0; i < taken.size(); ++i) ASSERT_EQ(taken[i].position, given[i].position);
}

TEST(ContourOptions, OddTolerances) {
  const Case cube(test::box_mesh({{0.1, 0.2, 0.3}, {1.1, 1.2, 1.3}}));
  for (const double tolerance : {0.023, 0.037, 1.0 / 7, 0.5, std::sqrt(3.0) / 16, std::sqrt(3.0), 10.0}) {
    const Contour contour = test::contour_of(cube.field, -0.2, tolerance);
    EXPECT_EQ(contour.report.undecided, 0U) << tolerance;
    EXPECT_LE(std::sqrt(3.0) / 2 * contour.report.subvoxel, tolerance / 2 * (1 + 1e-15));
    test::expect_true_points(cube, contour, 1 + contour.points.size() / 1000);
    test::expect_covered(contour, test::true_contour(cube, -0.2, cube.field.bounds(), 3000, 34));
  }
}

TEST(ContourOptions, HalfTheToleranceGivesFourTimesThePoints) {
  const Case sphere(test::sphere_mesh(3));
  double before = 0;
  for (const double tolerance : {0.2, 0.1, 0.05}) {
    const auto now = static_cast<double>(test::contour_of(sphere.field, -0.4, tolerance).points.size());
    if (before > 0) {
      EXPECT_GT(now / before, 3);
      EXPECT_LT(now / before, 5.5);
    }
    before = now;
  }
}

TEST(ContourOptions, FewPointsAreGivenTwice) {
  const Case sphere(test::sphere_mesh(3));
  const Contour contour = test::contour_of(sphere.field, -0.4, 0.1);
  std::set<std::tuple<double, double, double>> places;
  for (const ContourPoint& p : contour.points) places.insert({p.position.x, p.position.y, p.position.z});
  EXPECT_GT(static_cast<double>(places.size()), 0.98 * static_cast<double>(contour.points.size()));
}

}  // namespace
}  // namespace cdfr
