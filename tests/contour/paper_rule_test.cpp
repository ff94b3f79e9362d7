// The source paper's rule by name: the centres that a walk over every sub-voxel keeps, and no others.
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <tuple>

#include "cdfr/parts/part.h"
#include "contour/case.h"
#include "support/meshes.h"

namespace cdfr {
namespace {

using Place = std::tuple<double, double, double>;

struct Kept {
  std::set<Place> sure, unsure;  ///< unsure to rounding
};

/// Every sub-voxel of every leaf, asked one by one.
Kept kept_by_brute_force(const Field& field, double distance, double tolerance) {
  Kept kept;
  for (std::size_t i = 0; i < field.leaf_count(); ++i) {
    const Box box = field.leaf(i).box;
    const double size = box.hi.x - box.lo.x;
    int along = 1;
    while (0.8660254037844387 * size / along >= tolerance) along *= 2;
    const double sub = size / along;
    for (int k = 0; k < along * along * along; ++k) {
      const Vec3 c{box.lo.x + (k % along + 0.5) * sub, box.lo.y + (k / along % along + 0.5) * sub,
                   box.lo.z + (k / along / along + 0.5) * sub};
      const double beyond = std::fabs(field.distance(c) - distance) - tolerance / 2;
      if (std::fabs(beyond) < 1e-12) {
        kept.unsure.insert({c.x, c.y, c.z});
      } else if (beyond < 0) {
        kept.sure.insert({c.x, c.y, c.z});
      }
    }
  }
  return kept;
}

void expect_as_by_brute_force(const Mesh& mesh, double distance, double tolerance) {
  const Field field = Field::build(mesh.view()).value();
  const Kept kept = kept_by_brute_force(field, distance, tolerance);
  EXPECT_FALSE(kept.sure.empty());
  std::set<Place> found;
  const auto points = contour_points(field, distance, {tolerance, Rule::paper}).value();
  for (const ContourPoint& p : points) {
    const Box d = field.domain();
    const auto within = [](double x, double lo, double hi) { return x >= lo && x <= hi; };
    if (!within(p.position.x, d.lo.x, d.hi.x) || !within(p.position.y, d.lo.y, d.hi.y) ||
        !within(p.position.z, d.lo.z, d.hi.z))
      continue;  // the walk is over leaves alone
    const Place place{p.position.x, p.position.y, p.position.z};
    EXPECT_TRUE(found.insert(place).second);
    EXPECT_TRUE(kept.sure.count(place) + kept.unsure.count(place) == 1);
    const double side = distance < 0 ? -1 : 1;
    const double beyond = side * (field.distance(p.position) - distance);
    EXPECT_EQ(std::isinf(p.error), beyond < 0);
    if (beyond >= 0) {
      EXPECT_NEAR(p.error, beyond, 1e-12);
    }
  }
  for (const Place& place : kept.sure) EXPECT_EQ(found.count(place), 1U);
}

TEST(PaperRule, KeepsTheCentresThatTheWalkKeeps) {
  expect_as_by_brute_force(test::sphere_mesh(3), -0.3, 0.05);
  expect_as_by_brute_force(test::sphere_mesh(3), 0.05, 0.03);
  expect_as_by_brute_force(make_part("one-tooth").value(), -0.2, 0.06);
  expect_as_by_brute_force(test::box_mesh({{0, 0, 0}, {1, 1, 1}}), -0.25, 0.04);
  expect_as_by_brute_force(test::sphere_mesh(2), -0.1, 1.5);  // coarser than leaves
}

TEST(PaperRule, LosesASheetAlongTheAxes) {
  // Sub-voxels of edge s with sqrt(3)/2 s < E: centres may be s/2 > E/2 away.
  const Field plate = Field::build(test::box_mesh({{0, 0, 0}, {1, 1, 0.5}}).view()).value();
  const Box leaf = plate.leaf(0).box;
  bool lost = false;
  for (int i = 0; i < 40 && !lost; ++i) {
    const double depth = 0.1 + 0.001 * i, tolerance = (leaf.hi.x - leaf.lo.x) / 16 * 0.88;
    std::size_t top = 0;
    const auto points = contour_points(plate, -depth, {tolerance, Rule::paper}).value();
    for (const ContourPoint& p : points)
      top += p.position.z < 0.25 && p.position.x > 0.4 && p.position.x < 0.6 && p.position.y > 0.4 &&
             p.position.y < 0.6;
    lost = top == 0;
  }
  EXPECT_TRUE(lost);
}

}  // namespace
}  // namespace cdfr
