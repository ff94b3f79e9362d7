// A point whose coordinate lies on a cell's middle plane, face or corner belongs to several cells: an engine
// that goes down the tree by unlike comparisons reads a list that was not made for it.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "cdfr/field/field.h"
#include "faults/block_solid.h"
#include "faults/promise.h"
#include "faults/star.h"
#include "support/meshes.h"
#include "support/same.h"

namespace cdfr {
namespace {

BuildOptions many_leaves() {
  BuildOptions options;
  options.max_triangles_per_leaf = 4;
  options.max_level = 3;
  return options;
}

std::vector<Box> some_leaves(const Field& field, std::size_t count, std::uint64_t seed) {
  test::Random random(seed);
  std::vector<Box> boxes;
  for (std::size_t i = 0; i < count; ++i) boxes.push_back(field.leaf(random.below(field.leaf_count())).box);
  return boxes;
}

/// One to three coordinates at the leaf's middle, low or high plane.
Vec3 on_planes(const Box& box, test::Random& random) {
  Vec3 p = random.in(box);
  const auto planes = 1 + random.below(7);
  const auto put = [&](double& x, double lo, double hi) {
    const auto which = random.below(4);
    x = which == 0 ? lo : (which == 1 ? hi : lo + (hi - lo) / 2);
  };
  if ((planes & 1) != 0) put(p.x, box.lo.x, box.hi.x);
  if ((planes & 2) != 0) put(p.y, box.lo.y, box.hi.y);
  if ((planes & 4) != 0) put(p.z, box.lo.z, box.hi.z);
  return p;
}

TEST(WrongLeaf, TwentyThousandPointsOnMiddlePlanesAndCornersOfCells) {
  for (const Mesh& mesh : {test::sphere_mesh(3, 1, {0.1, 0.2, 0.3}), test::spiky_star(2, 5)}) {
    const Field field = Field::build(mesh.view(), many_leaves()).value();
    const BruteForce brute = BruteForce::over(mesh.view()).value();
    ASSERT_GT(field.leaf_count(), 500U);
    test::Random random(1);
    for (const Box& box : some_leaves(field, 500, 2)) {
      for (int i = 0; i < 20; ++i) {
        const Vec3 p = on_planes(box, random);
        ASSERT_TRUE(test::same_bits(field.closest(p), brute.closest(p))) << p.x << ' ' << p.y << ' ' << p.z;
      }
    }
  }
}

TEST(WrongLeaf, TwentyThousandPointsOnPlanesWithAClosedForm) {
  const test::BlockSolid solid({-1, 0.3, 2}, {0, 1, 1.7}, {0, 0.5, 1},
                               [](int i, int j, int k) { return !(i == 1 && j == 1 && k == 1); });
  BuildOptions options = many_leaves();
  options.max_triangles_per_leaf = 1;
  const Field field = Field::build(solid.mesh().view(), options).value();
  test::Random random(3);
  for (const Box& box : some_leaves(field, 1000, 4)) {
    for (int i = 0; i < 20; ++i) {
      const Vec3 p = on_planes(box, random);
      ASSERT_TRUE(test::is_right(field, p, solid.distance(p)));
    }
  }
}

TEST(WrongLeaf, AnUlpBesideAPlane) {
  const Mesh mesh = test::sphere_mesh(3, 1, {0.1, 0.2, 0.3});
  const Field field = Field::build(mesh.view(), many_leaves()).value();
  const BruteForce brute = BruteForce::over(mesh.view()).value();
  test::Random random(6);
  const auto beside = [&](double x) {
    const auto way = random.below(3);
    return way == 0 ? x : std::nextafter(x, way == 1 ? -9.0 : 9.0);
  };
  for (const Box& box : some_leaves(field, 500, 7)) {
    for (int i = 0; i < 10; ++i) {
      const Vec3 on = on_planes(box, random), p{beside(on.x), beside(on.y), beside(on.z)};
      ASSERT_TRUE(test::same_bits(field.closest(p), brute.closest(p))) << p.x << ' ' << p.y << ' ' << p.z;
    }
  }
}

TEST(WrongLeaf, OnTheFacesEdgesAndCornersOfTheDomain) {
  const Mesh mesh = test::sphere_mesh(3, 1, {0.1, 0.2, 0.3});
  for (const double margin : {0.0, 0.05, 1.0}) {
    BuildOptions options = many_leaves();
    options.margin = margin;
    const Field field = Field::build(mesh.view(), options).value();
    const BruteForce brute = BruteForce::over(mesh.view()).value();
    test::Random random(8);
    for (int i = 0; i < 2000; ++i) {
      const Vec3 p = on_planes(field.domain(), random);
      ASSERT_TRUE(test::same_bits(field.closest(p), brute.closest(p))) << margin;
    }
  }
}

}  // namespace
}  // namespace cdfr
