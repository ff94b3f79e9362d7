#include <gtest/gtest.h>

#include <cmath>

#include "cdfr/field/field.h"
#include "cdfr/mesh/audit.h"
#include "support/meshes.h"

namespace cdfr {
namespace {

TEST(Sign, IsThatOfTheBoxJustOffItsFacesEdgesAndCorners) {
  const Box box{{0, 0, 0}, {1, 2, 3}};
  const Field field = Field::build(test::box_mesh(box).view()).value();
  test::Random random(1);
  for (int i = 0; i < 20000; ++i) {
    const auto place = [&](double lo, double hi) {
      const double edge = random.below(2) == 0 ? lo : hi;
      const double off = std::ldexp(random.between(-1, 1), -static_cast<int>(random.below(60)));
      return random.below(2) == 0 ? random.between(lo, hi) : edge + off;
    };
    const Vec3 p{place(0, 1), place(0, 2), place(0, 3)};
    const bool inside = p.x > 0 && p.x < 1 && p.y > 0 && p.y < 2 && p.z > 0 && p.z < 3;
    const bool outside = p.x < 0 || p.x > 1 || p.y < 0 || p.y > 2 || p.z < 0 || p.z > 3;
    const double d = field.distance(p);
    if (inside) {
      ASSERT_LT(d, 0);
    } else if (outside) {
      ASSERT_GT(d, 0);
    } else {
      ASSERT_EQ(d, 0);
    }
  }
}

/// A wedge whose ridge is closed by a triangle of no area: its hidden normal must not decide.
TEST(Sign, SurvivesACapOfHeightZero) {
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, 3}, {2, 0, 0}};
  // The edge (0, 1) is split at vertex 4 on the bottom side only; (0, 4, 1) closes the gap.
  mesh.triangles = {{0, 2, 4}, {4, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {0, 4, 1}};
  const Field field = Field::build(mesh.view()).value();
  EXPECT_EQ(field.report().degenerate_triangles, 1U);
  EXPECT_TRUE(field.report().closed());
  const auto inside = [](const Vec3& p) {
    return p.z > 0 && 3 * p.y - p.z > 0 && 3 * p.x - p.z > 0 && 3 * p.x + 3 * p.y + 2 * p.z < 12;
  };
  test::Random random(2);
  for (int i = 0; i < 20000; ++i) {
    Vec3 p = random.in({{-1, -1, -1}, {5, 5, 4}});
    if (i % 2 == 0) {
      const double off = std::ldexp(1.0, -static_cast<int>(random.below(50)));
      p = {random.between(-0.5, 4.5), off * random.between(-1, 1), off * random.between(-1, 1)};
    }
    EXPECT_EQ(field.distance(p) < 0, inside(p)) << p.x << ' ' << p.y << ' ' << p.z;
  }
}

/// Joined with a cube far off, so that queries outside the part are inside the mesh's box.
Mesh with_far_cube(Mesh mesh, double x) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  const Mesh cube = test::box_mesh({{x, -2, -2}, {x + 1, 2, 2}});
  mesh.vertices.insert(mesh.vertices.end(), cube.vertices.begin(), cube.vertices.end());
  const Mesh other = test::box_mesh({{-x - 1, -2, -2}, {-x, 2, 2}});
  mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
  for (const std::uint32_t shift : {first, first + 8}) {
    for (const Triangle& t : cube.triangles)
      mesh.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
  }
  return mesh;
}

/// Past the tip the vertex is closest; its faces' angles are as small as the needle is thin.
TEST(Sign, IsOutsideAroundTheTipOfANeedle) {
  for (const double width : {1e-3, 1e-5, 1e-6, 1e-8, 1e-10, 1e-13}) {
    Mesh needle;
    needle.vertices = {{0.1, 0, 0}, {1.1, 1, 1}, {1.1 + width, 1, 1}, {1.1, 1 + width, 1}};
    needle.triangles = {{0, 2, 1}, {0, 3, 2}, {0, 1, 3}, {1, 2, 3}};
    const Mesh mesh = with_far_cube(needle, 20);
    ASSERT_GT(audit(needle.view()).value().volume, 0);
    const Field field = Field::build(mesh.view()).value();
    test::Random random(5);
    int tips = 0;
    for (int i = 0; i < 4000; ++i) {
      const Vec3 p = random.in({{-1, -1, -1}, {1.2, 1.1, 1.1}});
      const Closest c = field.closest(p);
      tips += c.feature == Feature::vertex;
      ASSERT_GE(c.distance, 0) << width;
    }
    EXPECT_GT(tips, 100);
  }
}

/// A tetrahedron so flat that the two normals of its edges cancel to their last bits.
TEST(Sign, IsOutsideAroundAVeryFlatTetrahedron) {
  Mesh flat;
  flat.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.3, 0.3, 0x1p-70}};
  flat.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  const Field field = Field::build(with_far_cube(flat, 20).view()).value();
  test::Random random(6);
  for (int i = 0; i < 4000; ++i) {
    const double off = std::ldexp(1.0, -static_cast<int>(random.below(60)));
    const Vec3 p{random.between(0.1, 0.9), -off, random.between(-0.5, 0.5)};
    ASSERT_GT(field.distance(p), 0);
  }
}

TEST(Sign, WindingOnAnOpenMeshUnlessAskedOtherwise) {
  Mesh open = test::box_mesh({{0, 0, 0}, {1, 1, 1}});
  open.triangles.pop_back();
  const Field field = Field::build(open.view()).value();
  EXPECT_EQ(field.sign(), Sign::winding);
  EXPECT_EQ(field.report().open_edges, 3U);
  EXPECT_LT(field.distance({0.5, 0.5, 0.5}), 0);
  BuildOptions options;
  options.sign = Sign::none;
  EXPECT_GT(Field::build(open.view(), options).value().distance({0.5, 0.5, 0.5}), 0);
  options.sign = Sign::pseudonormal;
  EXPECT_LT(Field::build(open.view(), options).value().distance({0.3, 0.5, 0.5}), 0);
}

Mesh flat_tetrahedron(double height) {
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0.25, 1, 0}, {0.375, 0.25, height}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  return mesh;
}

TEST(Sign, IsThatOfTheTrulyClosestFaceWhereTwoTieButForRounding) {
  // Straight above and below thin solids both sides are equally far, to the last bit of the kernel.
  for (const int k : {-30, -40, -60, -100, -106, -110, -150}) {
    const Mesh mesh = with_far_cube(flat_tetrahedron(std::ldexp(1.0, k)), 4);
    const Field field = Field::build(mesh.view()).value();
    test::Random random(5);
    for (int i = 0; i < 3000; ++i) {
      const double off = std::ldexp(random.between(0.5, 1), -static_cast<int>(random.below(20)));
      Vec3 p{random.between(-1, 2), random.between(-1, 2), i % 2 == 0 ? off : -off};
      if (i % 3 == 0) p = {random.between(0, 1), 0, p.z};
      EXPECT_GT(field.distance(p), 0) << k << ": " << p.x << ' ' << p.y << ' ' << p.z;
    }
  }
}

TEST(Sign, IsZeroExactlyOnFacesEvenNearTheirEdges) {
  Mesh mesh = flat_tetrahedron(1);
  const Field field = Field::build(mesh.view()).value();
  for (int k = 30; k <= 280; ++k) {
    EXPECT_EQ(field.distance({0.5, std::ldexp(1.0, -k), 0}), 0) << k;
    EXPECT_EQ(field.distance({0.5, std::ldexp(0.75, -k), 0}), 0) << k;
    EXPECT_EQ(field.distance({std::ldexp(1.0, -k), std::ldexp(1.0, -k), 0}), 0) << k;
    EXPECT_GT(field.distance({0.5, -std::ldexp(1.0, -k), 0}), 0) << k;
    EXPECT_GT(field.distance({0.5, 0, -std::ldexp(1.0, -k)}), 0) << k;
    EXPECT_LT(field.distance({0.375, std::ldexp(1.0, -k), std::ldexp(1.0, -k)}), 0) << k;
  }
}

TEST(Sign, LeavesThatNothingCrossesKnowTheirSide) {
  const Mesh mesh = test::sphere_mesh(4);
  const Field field = Field::build(mesh.view()).value();
  test::Random random(3);
  for (int i = 0; i < 2000; ++i) {
    const Leaf leaf = field.leaf(random.below(field.leaf_count()));
    const double d = field.distance(random.in(leaf.box));
    if (leaf.side == Side::inside) {
      EXPECT_LT(d, 0);
    }
    if (leaf.side == Side::outside) {
      EXPECT_GT(d, 0);
    }
  }
  const Stats stats = field.stats();
  EXPECT_GT(stats.inside_leaves, 0U);
  EXPECT_GT(stats.surface_leaves, 0U);
  EXPECT_GT(stats.outside_leaves, 0U);
}

}  // namespace
}  // namespace cdfr
