// At, just below and just above the greatest depth; empty contours are answers.
#include <gtest/gtest.h>

#include <cmath>

#include "contour/case.h"
#include "contour/coverage.h"
#include "support/meshes.h"
#include "support/random.h"

namespace cdfr {
namespace {

using test::Case;
using test::Contour;

void expect_empty(const Case& part, double distance, double tolerance) {
  const Contour contour = test::contour_of(part.field, distance, tolerance);
  EXPECT_TRUE(contour.points.empty()) << distance;
  EXPECT_EQ(contour.report.undecided, 0U);
  EXPECT_EQ(contour.report.productive, 0U);
  EXPECT_GT(contour.report.box.lo.x, contour.report.box.hi.x);
}

Case plate_from(double low, double thickness) {
  return Case(test::box_mesh({{0, 0, low}, {1, 1, low + thickness}}));
}

TEST(ContourExtremes, AboveHalfAPlateIsEmpty) {
  // On the lattice, off it, and thin against the tolerance.
  for (const double low : {0.0, 0.1, 1.0 / 3}) {
    for (const double thickness : {0.125, 0.1, 0.03}) {
      const double half = ((low + thickness) - low) / 2;
      for (const double above : {1e-3, 0.5, 40.0}) {
        expect_empty(plate_from(low, thickness), -half * (1 + above), 0.2);
      }
    }
  }
}

/// A slope of 1 could never tell: the walls' distances must be weighed against each other, along the
/// diagonals of the two sides as well.
TEST(ContourExtremes, JustAboveHalfAPlateIsEmptyAndDecided) {
  for (const double low : {0.0, 0.1}) {
    for (const double thickness : {0.125, 0.1}) {
      const double half = ((low + thickness) - low) / 2;
      expect_empty(plate_from(low, thickness), -half * (1 + 1e-9), 0.4);
    }
  }
}

TEST(ContourExtremes, AtHalfAPlateIsItsMiddlePlane) {
  const Box box{{0, 0, 0}, {1, 1, 0.125}};
  const Case plate(test::box_mesh(box));
  const Contour contour = test::contour_of(plate.field, -0.0625, 0.05);
  ASSERT_FALSE(contour.points.empty());
  test::expect_true_points(plate, contour);
  for (const ContourPoint& p : contour.points) {
    if (std::isfinite(p.error)) {
      EXPECT_NEAR(p.position.z, 0.0625, p.error);
    }
  }
  test::Random random(3);
  std::vector<Vec3> middle;
  for (int i = 0; i < 2000; ++i)
    middle.push_back({random.between(0.0625, 0.9375), random.between(0.0625, 0.9375), 0.0625});
  test::expect_contour_covers(plate, contour, middle);
}

/// No corner of any sub-voxel lies on this middle plane, and it is higher or lower than the depth by a
/// rounding: division decides nothing. The work must stay that of a sheet, not of its 2^-10 pieces.
TEST(ContourExtremes, AtHalfAPlateOffTheLattice) {
  const Case plate(test::box_mesh({{0, 0, 0.1}, {0.11, 0.11, 0.2}}));
  const double half = -plate.brute.closest({0.055, 0.055, 0.15}).distance;
  const Contour contour = test::contour_of(plate.field, -half, 0.4);
  ASSERT_FALSE(contour.points.empty());
  EXPECT_LT(contour.points.size(), 5000U);
  EXPECT_LT(contour.report.evaluations, 50000U);
  for (const ContourPoint& p : contour.points) EXPECT_NEAR(p.position.z, 0.15, 0.2);
}

/// So small a contour may stay undecided; it may not be lost.
TEST(ContourExtremes, CentreOfACube) {
  const Case cube(test::box_mesh({{0.1, 0.2, 0.3}, {1.1, 1.2, 1.3}}));
  const Contour below = test::contour_of(cube.field, -(0.5 - 1e-9), 0.02);
  EXPECT_LE(below.report.undecided, 8U);
  ASSERT_FALSE(below.points.empty());
  test::expect_true_points(cube, below);
  test::expect_covered(below, std::vector<Vec3>{{0.6, 0.7, 0.8}});
  expect_empty(cube, -(0.5 + 1e-4), 0.02);
  expect_empty(cube, -0.75, 0.02);
  expect_empty(cube, -1e9, 0.02);
}

TEST(ContourExtremes, CentreOfACubeExactly) {
  const Case cube(test::box_mesh({{0, 0, 0}, {1, 1, 1}}));
  const Contour contour = test::contour_of(cube.field, -0.5, 0.02);
  ASSERT_FALSE(contour.points.empty());
  test::expect_true_points(cube, contour);
  test::expect_covered(contour, std::vector<Vec3>{{0.5, 0.5, 0.5}});
}

TEST(ContourExtremes, AboveTheGreatestDepthOfAWedgeAndASphere) {
  const Case wedge(test::wedge_mesh());
  // The inscribed circle: t + t / sin(1 degree) = length.
  const double greatest = test::wedge_length / (1 + 1 / test::half_angle_sine());
  expect_empty(wedge, -greatest * 1.001, 0.2);
  EXPECT_FALSE(test::contour_of(wedge.field, -greatest * 0.999, 0.2).points.empty());
  const Case sphere(test::sphere_mesh(3));
  expect_empty(sphere, -1.0001, 0.05);
}

/// A flat sheet of two coinciding sides has no inside.
TEST(ContourExtremes, NothingInsideWhatHasNoVolume) {
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 1}};
  const Case sheet(std::move(mesh));
  if (sheet.field.sign() == Sign::none) {
    EXPECT_EQ(contour_points(sheet.field, -0.1).error().code, Code::not_closed);
  } else {
    expect_empty(sheet, -0.1, 0.05);
  }
  const Contour outside = test::contour_of(sheet.field, 0.1, 0.05);
  test::expect_true_points(sheet, outside);
  test::expect_covered(outside, test::true_contour(sheet, 0.1, {{-1, -1, -1}, {2, 2, 2}}, 3000, 2));
}

}  // namespace
}  // namespace cdfr
