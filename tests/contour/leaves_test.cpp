// Which leaves are visited: those that |d(centre) - t| <= sqrt(3)/2 s does not rule out, and no other.
#include <gtest/gtest.h>

#include <cmath>

#include "cdfr/parts/part.h"
#include "contour/case.h"
#include "support/meshes.h"

namespace cdfr {
namespace {

using test::Case;
using test::Contour;

struct Count {
  std::uint64_t surely = 0, perhaps = 0;
};

/// By brute force; leaves within a rounding of the limit may go either way.
Count leaves_near(const Case& part, double distance) {
  Count count;
  part.field.for_each_leaf([&](const Leaf& leaf) {
    const Box& box = leaf.box;
    const Vec3 centre{box.lo.x / 2 + box.hi.x / 2, box.lo.y / 2 + box.hi.y / 2, box.lo.z / 2 + box.hi.z / 2};
    const double size = box.hi.x - box.lo.x;
    const double gap = std::fabs(part.brute.closest(centre).distance - distance) - std::sqrt(3.0) / 2 * size;
    count.surely += gap <= -1e-12;
    count.perhaps += gap <= 1e-12;
  });
  return count;
}

void check(const Case& part, double distance, double tolerance) {
  const Contour contour = test::contour_of(part.field, distance, tolerance);
  const Count count = leaves_near(part, distance);
  EXPECT_EQ(contour.report.leaves, part.field.leaf_count());
  EXPECT_GE(contour.report.visited, count.surely) << distance;
  EXPECT_LE(contour.report.visited, count.perhaps) << distance;
  EXPECT_LT(contour.report.visited, contour.report.leaves) << distance;
  EXPECT_GT(contour.report.productive, 0U);
}

BuildOptions fine() {
  BuildOptions options;
  options.max_triangles_per_leaf = 8;
  options.gain = 1;
  options.max_level = 2;
  return options;
}

TEST(ContourLeaves, VisitedAreThoseNearTheContour) {
  const Case sphere(test::sphere_mesh(2), fine());
  for (const double distance : {-0.7, 0.0, 0.04}) check(sphere, distance, 0.2);
  const Case star(make_part("six-star").value(), fine());
  for (const double distance : {-0.35, 0.05}) check(star, distance, 0.2);
}

TEST(ContourLeaves, AreTheSameForEveryTolerance) {
  const Case sphere(test::sphere_mesh(3), fine());
  const ContourReport coarse = test::contour_of(sphere.field, -0.5, 0.5).report;
  const ContourReport close = test::contour_of(sphere.field, -0.5, 0.09).report;
  EXPECT_EQ(coarse.visited, close.visited);
  EXPECT_LE(close.productive, coarse.visited);
}

TEST(ContourLeaves, DepthOfTheOctreeChangesNoPromise) {
  for (const int level : {0, 1, 3}) {
    BuildOptions options = fine();
    options.max_level = level;
    const Case sphere(test::sphere_mesh(2), options);
    const Contour contour = test::contour_of(sphere.field, -0.3, 0.2);
    test::expect_true_points(sphere, contour, 2);
    EXPECT_FALSE(contour.points.empty());
  }
}

}  // namespace
}  // namespace cdfr
