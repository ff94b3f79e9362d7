// An octree cut at a level: complete lists, the same answers, and no leaf deeper.
#include <gtest/gtest.h>

#include <algorithm>

#include "cdfr/field/field.h"
#include "cdfr/parts/part.h"
#include "support/meshes.h"
#include "support/random.h"
#include "support/same.h"
#include "support/sanitized.h"

namespace cdfr {
namespace {

void expect_same_answers(const Field& field, const Field& cut) {
  test::Random random(3);
  const Box b = field.domain();
  const double m = (b.hi.x - b.lo.x) / 10;
  const Box around{{b.lo.x - m, b.lo.y - m, b.lo.z - m}, {b.hi.x + m, b.hi.y + m, b.hi.z + m}};
  for (int i = 0; i < (test::sanitized ? 400 : 4000); ++i) {
    const Vec3 x = random.in(around);
    const Closest a = field.closest(x), c = cut.closest(x);
    ASSERT_EQ(a.distance, c.distance);
    ASSERT_EQ(a.triangle, c.triangle);
    ASSERT_EQ(a.point, c.point);
  }
}

void expect_cuts(const Mesh& mesh, const BuildOptions& options = {}) {
  const Field field = Field::build(mesh.view(), options).value();
  std::size_t before = field.leaf_count() + 1;
  for (int level = 6; level >= 0; --level) {
    const Field cut = field.at_level(level).value();
    double volume = 0;
    for (std::size_t i = 0; i < cut.leaf_count(); ++i) {
      const Leaf leaf = cut.leaf(i);
      EXPECT_LE(leaf.level, level);
      EXPECT_TRUE(std::adjacent_find(leaf.triangles.begin(), leaf.triangles.end()) == leaf.triangles.end());
      const double s = leaf.box.hi.x - leaf.box.lo.x;
      volume += s * s * s;
    }
    const Box d = cut.domain();
    EXPECT_EQ(volume, (d.hi.x - d.lo.x) * (d.hi.y - d.lo.y) * (d.hi.z - d.lo.z));
    EXPECT_LE(cut.leaf_count(), before);
    before = cut.leaf_count();
    expect_same_answers(field, cut);
  }
  // A cut where nothing is deeper changes nothing.
  EXPECT_EQ(field.at_level(18).value().checksum(), field.checksum());
}

TEST(CutField, KeepsItsAnswersAtEveryLevel) {
  BuildOptions options;
  options.max_triangles_per_leaf = 20;
  expect_cuts(test::sphere_mesh(test::sanitized ? 3 : 4), options);
  expect_cuts(make_part("six-star").value(), options);
}

TEST(CutField, KeepsTheSignOfOpenAndMixedUpMeshes) {
  BuildOptions options;
  options.max_triangles_per_leaf = 10;
  Mesh open = test::sphere_mesh(3);
  open.triangles.resize(open.triangles.size() - 40);
  expect_cuts(open, options);
  expect_cuts(test::soup(60, {{0, 0, 0}, {1, 1, 1}}, 9), options);
}

TEST(CutField, KeepsDomains) {
  BuildOptions options;
  options.max_triangles_per_leaf = 20;
  options.domain = Domain::interior;
  expect_cuts(test::sphere_mesh(test::sanitized ? 3 : 4), options);
}

TEST(CutField, RefusesLevelsThatAreNone) {
  const Field field = Field::build(test::sphere_mesh(1).view()).value();
  for (const int level : {-1, 19}) EXPECT_EQ(field.at_level(level).error().code, Code::bad_option);
}

}  // namespace
}  // namespace cdfr
