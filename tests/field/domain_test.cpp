// Whatever domain a field has, its answers are those of all others.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "cdfr/contour/contour.h"
#include "cdfr/field/field.h"
#include "cdfr/parts/part.h"
#include "support/meshes.h"
#include "support/random.h"
#include "support/same.h"
#include "support/sanitized.h"

namespace cdfr {
namespace {

constexpr int fine = test::sanitized ? 3 : 4;

std::vector<BuildOptions> options_of_each() {
  BuildOptions options;
  options.max_triangles_per_leaf = 20;
  std::vector<BuildOptions> all{options};
  options.domain = Domain::interior;
  all.push_back(options);
  options.domain = Domain::band;
  for (const double band : {1e-6, 0.1, 0.7}) {
    options.band = band;
    all.push_back(options);
  }
  return all;
}

std::vector<Mesh> meshes() {
  Mesh open = test::sphere_mesh(fine);
  open.triangles.resize(open.triangles.size() - 60);
  Mesh twice = test::sphere_mesh(3);
  twice.triangles.insert(twice.triangles.end(), twice.triangles.begin(), twice.triangles.end());
  return {test::sphere_mesh(fine), open, twice, test::box_mesh({{0, 0, 0}, {1, 2, 3}}),
          make_part("tetrahedron").value()};
}

TEST(Domain, ChangesNoAnswer) {
  for (const Mesh& mesh : meshes()) {
    const Field box = Field::build(mesh.view(), options_of_each()[0]).value();
    Grid grid;
    const Box bounds = test::scaled(box.bounds(), 1.3);
    grid.origin = bounds.lo;
    grid.size = {17, 18, 19};
    grid.spacing = {(bounds.hi.x - bounds.lo.x) / 16, (bounds.hi.y - bounds.lo.y) / 17,
                    (bounds.hi.z - bounds.lo.z) / 18};
    std::vector<double> expected(grid.count()), got(grid.count());
    box.distance(grid, expected).value();
    for (const BuildOptions& options : options_of_each()) {
      const Field field = Field::build(mesh.view(), options).value();
      test::Random random(3);
      std::vector<Vec3> points;
      for (int i = 0; i < 1500; ++i)
        points.push_back(random.in(test::scaled(box.bounds(), i % 5 == 0 ? 4 : 1.2)));
      std::vector<double> distances(points.size());
      field.distance(Points(points), distances).value();
      for (std::size_t i = 0; i < points.size(); ++i) {
        ASSERT_TRUE(test::same_bits(field.closest(points[i]), box.closest(points[i])));
        ASSERT_EQ(distances[i], box.distance(points[i]));
      }
      field.distance(grid, got).value();
      ASSERT_EQ(got, expected);
    }
  }
}

TEST(Domain, LeavesOutWhatItSays) {
  const Mesh mesh = test::sphere_mesh(4);
  for (const BuildOptions& options : options_of_each()) {
    const Field field = Field::build(mesh.view(), options).value();
    const Stats stats = field.stats();
    if (options.domain == Domain::interior) {
      EXPECT_EQ(stats.outside_leaves, 0U);
      EXPECT_GT(stats.inside_leaves, 0U);
    }
    if (options.domain == Domain::band && options.band < 0.2) {
      const Stats all = Field::build(mesh.view(), options_of_each()[0]).value().stats();
      EXPECT_LT(stats.outside_leaves + stats.inside_leaves, all.outside_leaves + all.inside_leaves);
      EXPECT_LT(stats.entries, all.entries);
    }
    EXPECT_GT(stats.surface_leaves, 0U);
  }
}

/// In order, whole, and without those that are left out.
TEST(Domain, LeavesAreVisitedAsTheyAreCounted) {
  const Mesh mesh = test::sphere_mesh(fine);
  for (const BuildOptions& options : options_of_each()) {
    const Field field = Field::build(mesh.view(), options).value();
    const Stats stats = field.stats();
    std::size_t next = 0, seen = 0;
    field.for_each_leaf([&](const Leaf& leaf) {
      while (next < field.leaf_count() && field.leaf(next).key != leaf.key) ++next;
      ASSERT_LT(next, field.leaf_count());
      const Leaf one = field.leaf(next);
      EXPECT_EQ(leaf.box, one.box);
      EXPECT_EQ(leaf.side, one.side);
      EXPECT_EQ(leaf.triangles, one.triangles);
      ++seen;
    });
    EXPECT_EQ(seen,
              stats.inside_leaves + stats.surface_leaves + stats.outside_leaves + stats.undecided_leaves);
  }
}

/// Also where cells are left out.
TEST(Domain, ContoursAreWhole) {
  const Mesh mesh = test::sphere_mesh(3);
  const Field box = Field::build(mesh.view(), options_of_each()[0]).value();
  for (const BuildOptions& options : options_of_each()) {
    const Field field = Field::build(mesh.view(), options).value();
    for (const double distance : {-0.5, 0.0, 0.3}) {
      ContourOptions contour;
      contour.tolerance = 0.2;
      const auto points = contour_points(field, distance, contour).value();
      const auto all = contour_points(box, distance, contour).value();
      // Each near one of the others, both ways round.
      const auto covered = [](const auto& some, const auto& by) {
        for (const ContourPoint& p : some) {
          bool near = false;
          for (const ContourPoint& q : by) {
            near = near || std::hypot(p.position.x - q.position.x, p.position.y - q.position.y,
                                      p.position.z - q.position.z) < 0.41;
          }
          if (!near) return false;
        }
        return !some.empty();
      };
      EXPECT_TRUE(covered(all, points) && covered(points, all)) << distance;
    }
  }
}

TEST(Domain, RefusesWhatHasNone) {
  const Mesh mesh = test::sphere_mesh(2);
  BuildOptions options;
  options.domain = Domain::band;
  for (const double band : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
    options.band = band;
    EXPECT_EQ(Field::build(mesh.view(), options).error().code, Code::bad_option);
  }
  options.domain = Domain::interior;
  options.sign = Sign::none;
  EXPECT_EQ(Field::build(mesh.view(), options).error().code, Code::bad_option);
}

}  // namespace
}  // namespace cdfr
