#include "geometry/angle_sum.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "support/meshes.h"
#include "support/random.h"
#include "support/winding.h"

namespace cdfr {
namespace {

const Box around{{-2, -2, -2}, {2, 2, 2}};

/// All edges of all triangles: those inside cancel.
template <class Add>
void for_edges(const Mesh& mesh, Add add) {
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) add(mesh.vertices[t[k]], mesh.vertices[t[(k + 1) % 3]]);
  }
}

Mesh holed_sphere() {
  Mesh mesh = test::sphere_mesh(2);
  mesh.triangles.resize(mesh.triangles.size() - 60);
  return mesh;
}

TEST(AngleSum, WhatEdgesSweepIsTheChangeOfTheWindingNumberButForWholeOnes) {
  test::Random random(3);
  for (const Mesh& mesh : {holed_sphere(), test::soup(40, {{-1, -1, -1}, {1, 1, 1}}, 5)}) {
    int moved = 0;
    for (int i = 0; i < 300; ++i) {
      const Vec3 p = random.in(around), q = random.in(around);
      AngleSum swept;
      for_edges(mesh, [&](const Vec3& a, const Vec3& b) { swept.add_swept(p, q, a, b); });
      const Bounded sum = swept.sum();
      if (!(sum.error < 1)) continue;
      const double change = test::brute_winding(mesh.view(), p) - test::brute_winding(mesh.view(), q);
      const double whole = change - sum.value / four_pi;
      EXPECT_LE(std::fabs(whole - std::round(whole)), sum.error / four_pi + 1e-12);
      EXPECT_LE(sum.error, 1e-5);
      ++moved;
    }
    EXPECT_GT(moved, 290);
  }
}

/// Many small steps away from the surface: no sphere is missing or too many.
TEST(AngleSum, WithoutACrossingNothingWholeIsLeft) {
  const Mesh mesh = holed_sphere();
  test::Random random(4);
  for (int i = 0; i < 300; ++i) {
    const Vec3 q = random.in({{-0.4, -0.4, -0.4}, {0.4, 0.4, 0.4}});
    const Vec3 p = random.in({{-0.4, -0.4, -0.4}, {0.4, 0.4, 0.4}});
    AngleSum swept;
    for_edges(mesh, [&](const Vec3& a, const Vec3& b) { swept.add_swept(p, q, a, b); });
    const double change = test::brute_winding(mesh.view(), p) - test::brute_winding(mesh.view(), q);
    EXPECT_NEAR(swept.sum().value / four_pi, change, swept.sum().error + 1e-12);
  }
}

TEST(AngleSum, TrianglesToInfinityAddUpToTheirSolidAngles) {
  test::Random random(5);
  for (int i = 0; i < 200; ++i) {
    const Vec3 p = random.in(around), back{0.6, 0, -0.8};
    AngleSum sum;
    Bounded expected;
    for (int k = 0; k < 100; ++k) {
      const Vec3 a = random.in(around), b = random.in(around);
      sum.add_to_infinity(p, a, b, back);
      const Bounded angle = solid_angle_to_infinity(p, a, b, back);
      expected.value += angle.value;
      expected.error += angle.error;
    }
    if (sum.sum().error < 1) {
      EXPECT_NEAR(sum.sum().value, expected.value, sum.sum().error + expected.error);
    }
  }
}

TEST(AngleSum, WholeTurnsAreKept) {
  const Vec3 p{0, 0, 0}, a{1, 0, 0.01}, b{-0.5, 0.8, 0.01}, c{-0.5, -0.8, 0.01}, up{0, 0, 1};
  AngleSum sum;
  for (int i = 0; i < 50; ++i) {
    sum.add_to_infinity(p, a, b, up);
    sum.add_to_infinity(p, b, c, up);
    sum.add_to_infinity(p, c, a, up);
  }
  const double once = solid_angle_to_infinity(p, a, b, up).value +
                      solid_angle_to_infinity(p, b, c, up).value + solid_angle_to_infinity(p, c, a, up).value;
  EXPECT_GT(std::fabs(once), 6);
  EXPECT_NEAR(sum.sum().value, 50 * once, 1e-8);
}

TEST(AngleSum, AWayThroughAnEdgeOrToItIsLeftOpen) {
  for (const Vec3& q : {Vec3{0, 0, -1}, Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{0, 0x1p-60, -1}}) {
    AngleSum sum;
    sum.add_swept({0, 0, 1}, q, {-1, 0, 0}, {1, 0, 0});
    EXPECT_TRUE(std::isinf(sum.sum().error)) << q.x << ' ' << q.y << ' ' << q.z;
  }
}

}  // namespace
}  // namespace cdfr
