// Where a contour is sharp: the ray from a foot through a sub-voxel's centre crosses the medial axis before
// it is at height, and nothing but subdivision finds the point.
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

Box shrunk(const Box& box, double by) {
  return {{box.lo.x + by, box.lo.y + by, box.lo.z + by}, {box.hi.x - by, box.hi.y - by, box.hi.z - by}};
}

TEST(ContourRidge, CornersAndEdgesInsideACube) {
  const Box box{{0.1, 0.2, 0.3}, {1.1, 1.2, 1.3}};
  const Case cube(test::box_mesh(box));
  for (const double depth : {0.05, 0.3, 0.45, 0.499}) {
    const Contour contour = test::contour_of(cube.field, -depth, 0.043);
    EXPECT_EQ(contour.report.undecided, 0U);
    test::expect_true_points(cube, contour, 1 + contour.points.size() / 2000);
    test::expect_contour_covers(cube, contour, test::points_on_edges(shrunk(box, depth), 3000, 8));
  }
}

TEST(ContourRidge, EdgesInsideAPlateAlmostAtHalfItsThickness) {
  const Box box{{0.1, 0.2, 0.3}, {1.1, 1.2, 0.4}};
  const Case plate(test::box_mesh(box));
  for (const double depth : {0.04, 0.0499, 0.0499999}) {
    const Contour contour = test::contour_of(plate.field, -depth, 0.043);
    EXPECT_EQ(contour.report.undecided, 0U);
    test::expect_true_points(plate, contour, 1 + contour.points.size() / 2000);
    test::expect_contour_covers(plate, contour, test::points_on_edges(shrunk(box, depth), 3000, 9));
  }
}

TEST(ContourRidge, ConcaveEdgesOutsideTwoPlates) {
  // Open at the sides, the gap between two plates has contours with edges of their own.
  Mesh mesh = test::box_mesh({{0, 0, 0}, {1, 1, 0.1}});
  const Mesh wall = test::box_mesh({{0, 0, 0.1}, {0.1, 1, 1}});
  mesh.vertices.insert(mesh.vertices.end(), wall.vertices.begin(), wall.vertices.end());
  for (const Triangle& f : wall.triangles) mesh.triangles.push_back({f[0] + 8, f[1] + 8, f[2] + 8});
  BuildOptions unsigned_field;
  unsigned_field.sign = Sign::none;
  const Case corner(std::move(mesh), unsigned_field);
  const double t = 0.2;
  const Contour contour = test::contour_of(corner.field, t, 0.05);
  test::expect_true_points(corner, contour, 5);
  test::Random random(4);
  std::vector<Vec3> valley;
  for (int i = 0; i < 1000; ++i) valley.push_back({0.1 + t, random.between(0, 1), 0.1 + t});
  test::expect_contour_covers(corner, contour, valley);
}

/// The contour's edge along the bisector is 1/sin(1 degree) = 57 depths away from the wedge's tip.
TEST(ContourRidge, BisectorOfATwoDegreeWedge) {
  const Case wedge(test::wedge_mesh());
  for (const double depth : {0.002, 0.01, 0.02}) {
    const Contour contour = test::contour_of(wedge.field, -depth, 0.05);
    EXPECT_EQ(contour.report.undecided, 0U);
    test::expect_true_points(wedge, contour, 11);
    test::Random random(6);
    std::vector<Vec3> ridge;
    for (int i = 0; i < 2000; ++i) {
      ridge.push_back(
          {depth / test::half_angle_sine(), random.between(depth, test::wedge_length - depth), 0});
    }
    test::expect_contour_covers(wedge, contour, ridge);
  }
}

/// A tolerance far above the wall's thickness: the whole ridge lies in few sub-voxels.
TEST(ContourRidge, IsFoundAtACoarseTolerance) {
  const Box box{{0.1, 0.2, 0.3}, {1.1, 1.2, 0.33}};
  const Case plate(test::box_mesh(box));
  for (const double tolerance : {0.1, 0.37, 1.1}) {
    for (const double depth : {0.001, 0.0149}) {
      const Contour contour = test::contour_of(plate.field, -depth, tolerance);
      EXPECT_EQ(contour.report.undecided, 0U);
      test::expect_true_points(plate, contour);
      test::expect_contour_covers(plate, contour, test::points_on_edges(shrunk(box, depth), 1000, 10));
    }
  }
}

}  // namespace
}  // namespace cdfr
