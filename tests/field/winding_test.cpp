#include "field/winding.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "cdfr/field/field.h"
#include "cdfr/mesh/flip.h"
#include "field/field_data.h"
#include "mesh/crossings.h"
#include "support/joined.h"
#include "support/meshes.h"
#include "support/same.h"
#include "support/winding.h"

namespace cdfr {
namespace {

const Box unit{{0, 0, 0}, {1, 1, 1}};

Mesh open_box() {
  Mesh mesh = test::box_mesh({{0, 0, 0}, {4, 4, 4}});
  mesh.triangles.erase(mesh.triangles.begin() + 2, mesh.triangles.begin() + 4);  // the top
  return mesh;
}

Mesh holed_sphere() {
  Mesh mesh = test::sphere_mesh(4);
  mesh.triangles.resize(mesh.triangles.size() - 75);
  return mesh;
}

TEST(Winding, ASumIsWithinItsBoundAtAnyOpening) {
  Mesh far = test::moved(test::sphere_mesh(2, 0x1p-20), {0x1p20, 0x1p19, -0x1p20});
  far.triangles.pop_back();
  for (const Mesh& mesh : {test::soup(1000, unit, 4), holed_sphere(), open_box(), far}) {
    BuildOptions options;
    options.max_level = 1;
    const Field field = Field::build(mesh.view(), options).value();
    const FieldData& data = field.data();
    ASSERT_FALSE(data.winding.empty());
    test::Random random(8);
    double largest_error = 0;
    for (int i = 0; i < 150; ++i) {
      const Vec3 p = random.in(test::scaled(field.bounds(), i % 3 == 0 ? 10 : 1.5));
      const double truth = test::brute_winding(mesh.view(), p);
      for (const double opening : {1.1, 2.0, 4.0, std::numeric_limits<double>::infinity()}) {
        const Bounded w = winding_number(data.winding, data.space(), p, opening);
        EXPECT_NEAR(w.value, truth, w.error + 1e-12) << opening;
        EXPECT_LE(winding_by_boundary(data.winding, data.space(), p).error, 1e-6);
        EXPECT_NEAR(winding_by_boundary(data.winding, data.space(), p).value, truth, 1e-9);
        if (opening == 4) largest_error = std::max(largest_error, w.error);
      }
    }
    EXPECT_LT(largest_error, 1.0);
  }
}

/// Agreement wherever the winding number is more than 1e-6 from 1/2, at any depth of the octree.
void expect_signs_of(const Mesh& mesh, std::size_t points, const std::string& name) {
  for (const int level : {0, 2, 4}) {
    BuildOptions options;
    options.sign = Sign::winding;
    options.max_level = level;
    options.max_triangles_per_leaf = 16;
    const Field field = Field::build(mesh.view(), options).value();
    test::Random random(static_cast<std::uint64_t>(level) + 5);
    int wrong = 0;
    for (std::size_t i = 0; i < points; ++i) {
      Vec3 p = random.in(test::scaled(field.bounds(), i % 4 == 0 ? 3 : 1.1));
      if (i % 2 == 0) {
        const double off = std::ldexp(test::longest(field.bounds()), -2 - static_cast<int>(random.below(30)));
        const Vec3 q = field.closest(p).point, shift = random.in({{-1, -1, -1}, {1, 1, 1}});
        p = {q.x + off * shift.x, q.y + off * shift.y, q.z + off * shift.z};
      }
      const double w = test::brute_winding(mesh.view(), p);
      if (std::fabs(w - 0.5) <= 1e-6) continue;
      const double d = field.distance(p);
      if (d == 0 || (d < 0) == (w > 0.5)) continue;
      if (wrong++ < 3) ADD_FAILURE() << name << " level " << level << ": w = " << w << ", distance " << d;
    }
    EXPECT_EQ(wrong, 0) << name << " of " << points;
  }
}

TEST(Winding, DecidesTheSignOfOpenAndMixedUpMeshes) {
  expect_signs_of(open_box(), 2000, "open box");
  expect_signs_of(holed_sphere(), 300, "holed sphere");
  expect_signs_of(test::soup(60, unit, 9), 300, "soup");
  Mesh half = test::sphere_mesh(3);
  for (std::size_t i = 0; i < half.triangles.size(); i += 2)
    std::swap(half.triangles[i][1], half.triangles[i][2]);
  expect_signs_of(half, 500, "half flipped");
}

TEST(Winding, DecidesTheSignOfBalancedMeshes) {
  const Mesh cube = test::box_mesh(unit);
  expect_signs_of(test::joined(cube, test::moved(cube, {1, 0, 0})), 2000, "two cubes face to face");
  expect_signs_of(test::joined(cube, test::moved(cube, {0.5, 0.25, 0.5})), 2000, "two cubes crossing");
  expect_signs_of(test::joined(cube, cube), 1000, "a cube twice");
  expect_signs_of(test::joined(test::sphere_mesh(3, 2), test::sphere_mesh(2, 1)), 500,
                  "a sphere in a sphere");
  Mesh inward = test::sphere_mesh(3);
  flip(inward);
  expect_signs_of(inward, 500, "inside out");
  expect_signs_of(test::joined(cube, inward), 1000, "a cube and an inward sphere");
  Mesh pillow = cube;
  pillow.vertices.insert(pillow.vertices.end(), {{2, 0, 0}, {3, 0, 0}, {2, 1, 0}});
  pillow.triangles.insert(pillow.triangles.end(), {{8, 9, 10}, {8, 10, 9}});
  expect_signs_of(pillow, 1000, "a cube and a sheet of two faces");
}

TEST(Winding, LeavesCarryASideOnlyWhereAllOfThemIsOnIt) {
  for (const Mesh& mesh : {open_box(), holed_sphere()}) {
    BuildOptions options;
    options.max_triangles_per_leaf = 2;
    options.max_level = 2;
    options.gain = 1;
    const Field field = Field::build(mesh.view(), options).value();
    test::Random random(2);
    std::size_t decided = 0, undecided = 0;
    for (std::size_t i = 0; i < field.leaf_count(); i += 11) {
      const Leaf leaf = field.leaf(i);
      undecided += leaf.side == Side::undecided;
      if (leaf.side != Side::inside && leaf.side != Side::outside) continue;
      ++decided;
      for (int k = 0; k < 3; ++k) {
        EXPECT_EQ(test::brute_winding(mesh.view(), random.in(leaf.box)) > 0.5, leaf.side == Side::inside);
      }
    }
    EXPECT_GT(decided, 100U);
    EXPECT_GT(undecided, 0U);
    EXPECT_LT(undecided, decided);
  }
}

/// Sheets of two faces with a corner on each of the first rays from the origin.
Mesh spoiler(std::uint32_t rays) {
  Mesh mesh;
  for (std::uint32_t i = 0; i < rays; ++i) {
    const Vec3 d = ray_direction(i);
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(),
                         {d, {d.x + 0.01, d.y, d.z + 0.01}, {d.x + 0.01, d.y + 0.01, d.z}});
    mesh.triangles.insert(mesh.triangles.end(),
                          {{first, first + 1, first + 2}, {first, first + 2, first + 1}});
  }
  return mesh;
}

TEST(Winding, IsRightWhereAllRaysAreSpoilt) {
  const Mesh cube = test::box_mesh({{-4, -4, -4}, {4, 4, 4}});
  Mesh open = cube;
  open.triangles.pop_back();
  const Vec3 origin{0, 0, 0};
  EXPECT_LT(Field::build(test::joined(open, spoiler(70)).view()).value().distance(origin), 0);
  const Field closed = Field::build(test::joined(cube, spoiler(70)).view()).value();
  EXPECT_TRUE(closed.report().balanced());
  EXPECT_EQ(winding_by_crossings(origin, closed.data().space()), 1);
  EXPECT_LT(closed.distance(origin), 0);
}

TEST(Winding, ANeedlesMomentsAreWithinTheirBound) {
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 1, 1}, {0.5, 0.5, 0.5 + 1e-10}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0.3}};
  mesh.triangles = {{0, 1, 2}};
  const Field field = Field::build(mesh.view()).value();
  test::Random random(3);
  for (const double far : {1e1, 1e3, 1e5}) {
    for (int i = 0; i < 200; ++i) {
      const Vec3 p = random.in({{-far, -far, -far}, {far, far, far}});
      const Bounded w = winding_number(field.data().winding, field.data().space(), p, 2);
      const Bounded exact = winding_number(field.data().winding, field.data().space(), p,
                                           std::numeric_limits<double>::infinity());
      EXPECT_LE(std::fabs(w.value - exact.value), w.error + exact.error);
    }
  }
}

TEST(Winding, BruteForceAndTreeAgreeBitForBit) {
  const Mesh cube = test::box_mesh(unit);
  for (const Mesh& mesh :
       {open_box(), holed_sphere(), test::joined(cube, test::moved(cube, {0.5, 0.25, 0.5})),
        test::soup(150, unit, 3)}) {
    const Field field = Field::build(mesh.view()).value();
    const BruteForce brute = BruteForce::over(mesh.view()).value();
    test::Random random(6);
    for (int i = 0; i < 400; ++i) {
      const Vec3 p = random.in(test::scaled(field.bounds(), i % 2 == 0 ? 1.1 : 4));
      EXPECT_TRUE(test::same_bits(field.closest(p), brute.closest(p)));
    }
  }
}

TEST(Winding, FollowsTheMeshToAnySize) {
  const Mesh mesh = open_box();
  const Field field = Field::build(mesh.view()).value();
  for (const int k : {-190, -30, 30, 190}) {
    Mesh sized = mesh;
    for (Vec3& v : sized.vertices) v = {std::ldexp(v.x, k), std::ldexp(v.y, k), std::ldexp(v.z, k)};
    const Field other = Field::build(sized.view()).value();
    test::Random random(6);
    for (int i = 0; i < 200; ++i) {
      const Vec3 p = random.in(test::scaled(field.bounds(), 2));
      const Vec3 q{std::ldexp(p.x, k), std::ldexp(p.y, k), std::ldexp(p.z, k)};
      EXPECT_EQ(other.distance(q), std::ldexp(field.distance(p), k));
    }
    EXPECT_GT(other.distance({std::ldexp(1.0, 900), 0, 0}), 0);
  }
}

}  // namespace
}  // namespace cdfr
