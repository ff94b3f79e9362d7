// Offsets that lose their sharp edges and corners, or invent sheets where a shape comes near itself. Contours
// are points here; closed offset meshes are not part of this file.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "cdfr/contour/contour.h"
#include "cdfr/field/field.h"
#include "faults/block_solid.h"
#include "faults/promise.h"

namespace cdfr {
namespace {

const test::Planes unit{0, 1};

std::vector<ContourPoint> contour(const Field& field, double distance, double tolerance) {
  ContourOptions options;
  options.tolerance = tolerance;
  return contour_points(field, distance, options).value();
}

double nearest(const std::vector<ContourPoint>& points, const Vec3& x) {
  double least = HUGE_VAL;
  for (const ContourPoint& p : points) {
    least = std::min(least, test::length_of({p.position.x - x.x, p.position.y - x.y, p.position.z - x.z}));
  }
  return least;
}

Vec3 corner_of(const Box& box, unsigned which) {
  return {(which & 1U) != 0 ? box.hi.x : box.lo.x, (which & 2U) != 0 ? box.hi.y : box.lo.y,
          (which & 4U) != 0 ? box.hi.z : box.lo.z};
}

/// Corners, and points of the edges from one corner to its neighbours.
void expect_sharp(const std::vector<ContourPoint>& points, const Box& box, double tolerance) {
  for (unsigned which = 0; which < 8; ++which) {
    EXPECT_LE(nearest(points, corner_of(box, which)), tolerance) << "corner " << which;
    for (unsigned axis = 0; axis < 3; ++axis) {
      const Vec3 a = corner_of(box, which), b = corner_of(box, which ^ (1U << axis));
      for (const double t : {0.03, 0.21, 0.47}) {
        const Vec3 on{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.z + t * (b.z - a.z)};
        EXPECT_LE(nearest(points, on), tolerance) << "edge " << which << ' ' << axis;
      }
    }
  }
}

/// The closed form says that each point is where it claims to be.
void expect_no_ghost(const std::vector<ContourPoint>& points, const test::BlockSolid& solid,
                     double distance) {
  ASSERT_FALSE(points.empty());
  for (const ContourPoint& p : points) {
    ASSERT_TRUE(std::isfinite(p.error));
    ASSERT_LE(std::fabs(solid.distance(p.position) - static_cast<long double>(distance)),
              static_cast<long double>(p.error));
  }
}

TEST(LostEdge, AnInnerOffsetOfACubeKeepsItsCornersAndEdges) {
  const test::BlockSolid solid = test::block({{0.1, 0.2, 0.3}, {1.1, 1.2, 1.3}});
  const Field field = Field::build(solid.mesh().view()).value();
  for (const double depth : {0.05, 0.31, 0.48}) {
    const double tolerance = 0.04;
    const std::vector<ContourPoint> points = contour(field, -depth, tolerance);
    const Box box = solid.box();
    expect_sharp(points,
                 {{box.lo.x + depth, box.lo.y + depth, box.lo.z + depth},
                  {box.hi.x - depth, box.hi.y - depth, box.hi.z - depth}},
                 tolerance);
    expect_no_ghost(points, solid, -depth);
  }
}

/// Outside a convex corner the offset is round: it reaches the middle of that round corner and no farther.
TEST(LostEdge, AnOuterOffsetOfACubeReachesRoundItsCorners) {
  const test::BlockSolid solid = test::block({{0, 0, 0}, {1, 1, 1}});
  const Field field = Field::build(solid.mesh().view()).value();
  const double t = 0.2, tolerance = 0.05, out = t / std::sqrt(3.0);
  const std::vector<ContourPoint> points = contour(field, t, tolerance);
  for (unsigned which = 0; which < 8; ++which) {
    EXPECT_LE(nearest(points, corner_of({{-out, -out, -out}, {1 + out, 1 + out, 1 + out}}, which)),
              tolerance);
  }
  expect_no_ghost(points, solid, t);
}

/// A cavity is outside, so its positive offset is a smaller cube with sharp corners.
TEST(LostEdge, AnOuterOffsetIntoACavityKeepsItsCornersAndEdges) {
  const test::Planes planes{-1, 0, 1, 2};
  const test::BlockSolid solid(planes, planes, planes,
                               [](int i, int j, int k) { return i != 1 || j != 1 || k != 1; });
  const Field field = Field::build(solid.mesh().view()).value();
  const double t = 0.3, tolerance = 0.06;
  const std::vector<ContourPoint> points = contour(field, t, tolerance);
  expect_sharp(points, {{t, t, t}, {1 - t, 1 - t, 1 - t}}, tolerance);
  expect_no_ghost(points, solid, t);
}

/// Along the inner edge of an angle the outer offset has a sharp valley.
TEST(LostEdge, AnOuterOffsetOfAnAngleKeepsItsValley) {
  const test::BlockSolid solid({0, 0.2, 1}, {0, 0.2, 1}, unit,
                               [](int i, int j, int) { return i == 0 || j == 0; });
  const Field field = Field::build(solid.mesh().view()).value();
  const double t = 0.25, tolerance = 0.04;
  const std::vector<ContourPoint> points = contour(field, t, tolerance);
  for (const double z : {0.0, 0.13, 0.5, 0.77, 1.0})
    EXPECT_LE(nearest(points, {0.2 + t, 0.2 + t, z}), tolerance);
  expect_no_ghost(points, solid, t);
}

/// A slot of 0.2 between two walls: an offset above 0.1 has no sheet in it, one below has two.
TEST(LostEdge, NoGhostsWhereTheShapeComesNearItself) {
  const test::BlockSolid fork({0, 0.4, 0.6, 1}, {0, 0.2, 1}, unit,
                              [](int i, int j, int) { return i != 1 || j == 0; });
  const Field field = Field::build(fork.mesh().view()).value();
  const double tolerance = 0.04;
  const auto in_slot = [](const ContourPoint& p) {
    const Vec3& x = p.position;
    return x.x > 0.4 && x.x < 0.6 && x.y > 0.2 && x.y < 1 && x.z > 0 && x.z < 1;
  };
  for (const double t : {0.1 + 1e-6, 0.11, 0.15}) {
    const std::vector<ContourPoint> points = contour(field, t, tolerance);
    EXPECT_EQ(std::count_if(points.begin(), points.end(), in_slot), 0) << t;
    expect_no_ghost(points, fork, t);
  }
  const std::vector<ContourPoint> points = contour(field, 0.0625, tolerance);
  for (const double x : {0.4625, 0.5375}) EXPECT_LE(nearest(points, {x, 0.6, 0.5}), tolerance);
  expect_no_ghost(points, fork, 0.0625);
}

/// Inside, two arms that meet: the inner offset above half an arm's width is in the foot alone.
TEST(LostEdge, NoGhostsInWallsThinnerThanTheOffset) {
  const test::BlockSolid fork({0, 0.2, 0.8, 1}, {0, 0.6, 1}, unit,
                              [](int i, int j, int) { return i != 1 || j == 0; });
  const Field field = Field::build(fork.mesh().view()).value();
  for (const double depth : {0.1 + 1e-6, 0.15, 0.25}) {
    const std::vector<ContourPoint> points = contour(field, -depth, 0.03);
    expect_no_ghost(points, fork, -depth);
    for (const ContourPoint& p : points) ASSERT_LE(p.position.y, 0.8);
  }
}

}  // namespace
}  // namespace cdfr
