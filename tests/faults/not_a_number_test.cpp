// On the surface: the distance is zero, not NaN and not a rounding; the gradient is a unit vector on the
// outer side.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "cdfr/field/field.h"
#include "faults/block_solid.h"
#include "faults/promise.h"
#include "faults/star.h"
#include "support/joined.h"
#include "support/meshes.h"

namespace cdfr {
namespace {

std::array<Vec3, 3> corners_of(const Mesh& mesh, const Triangle& t) {
  return {mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]};
}

Vec3 weighted(const std::array<Vec3, 3>& v, double a, double b, double c) {
  return {a * v[0].x + b * v[1].x + c * v[2].x, a * v[0].y + b * v[1].y + c * v[2].y,
          a * v[0].z + b * v[1].z + c * v[2].z};
}

void expect_zero(const Field& field, const Vec3& p) {
  const Closest c = field.closest(p);
  ASSERT_EQ(c.distance, 0) << p.x << ' ' << p.y << ' ' << p.z;
  ASSERT_EQ(field.distance(p), 0);
  ASSERT_EQ(c.point, p);
  ASSERT_NEAR(test::length_of(c.gradient), 1, 1e-15);
}

/// Whole coordinates: points of an edge at quarters and of a face at eighths are exact.
TEST(NotANumber, ZeroOnVerticesEdgesAndFaces) {
  for (const Mesh& mesh : {test::spiky_star(2, 1), test::many_fans(104), test::flat_tetrahedron(),
                           test::block({{0, 0, 0}, {1, 2, 3}}).mesh()}) {
    const Field field = Field::build(mesh.view()).value();
    for (const Triangle& t : mesh.triangles) {
      const std::array<Vec3, 3> v = corners_of(mesh, t);
      for (const auto& w : {std::array{1.0, 0.0, 0.0}, std::array{0.5, 0.5, 0.0}, std::array{0.0, 0.25, 0.75},
                            std::array{0.25, 0.5, 0.25}, std::array{0.125, 0.125, 0.75}}) {
        ASSERT_NO_FATAL_FAILURE(expect_zero(field, weighted(v, w[0], w[1], w[2])));
      }
    }
  }
}

TEST(NotANumber, ZeroOnVerticesOfAnyMesh) {
  Mesh open = test::sphere_mesh(2, 0.7, {0.1, 1e3, -7});
  open.triangles.resize(100);
  Mesh heap;
  heap.vertices = {{3, 4, 5}};
  heap.triangles.assign(20, {0, 0, 0});
  for (const Mesh& mesh :
       {test::sphere_mesh(3, 1, {0.1, 0.2, 0.3}), open, heap, test::soup(100, {{0, 0, 0}, {1, 1, 1}}, 1),
        test::joined(heap, test::soup(30, {{-1e6, 0, 0}, {1e6, 1e-6, 1}}, 2))}) {
    for (const Sign sign : {Sign::automatic, Sign::pseudonormal, Sign::none}) {
      BuildOptions options;
      options.sign = sign;
      const Field field = Field::build(mesh.view(), options).value();
      for (const Triangle& t : mesh.triangles) {
        for (const std::uint32_t v : t) ASSERT_NO_FATAL_FAILURE(expect_zero(field, mesh.vertices[v]));
      }
    }
  }
}

/// Towards the surface, halving the way until nothing is left of it: finite and never across.
TEST(NotANumber, FiniteAllTheWayToTheSurface) {
  const Mesh mesh = test::spiky_star(2, 3);
  const Field field = Field::build(mesh.view()).value();
  test::Random random(4);
  for (int i = 0; i < 200; ++i) {
    const Vec3 start = random.in(field.bounds());
    const Closest first = field.closest(start);
    for (double share = 1; share > 1e-20; share /= 4) {
      const auto toward = [share](double from, double to) { return to + (from - to) * share; };
      const Closest c = field.closest(
          {toward(start.x, first.point.x), toward(start.y, first.point.y), toward(start.z, first.point.z)});
      ASSERT_TRUE(std::isfinite(c.distance));
      ASSERT_NEAR(test::length_of(c.gradient), 1, 1e-15);
      ASSERT_NEAR(c.distance, first.distance * share, 1e-12);
    }
  }
}

/// The outer side: convex corners and edges point away from the middle.
TEST(NotANumber, TheGradientOnTheSurfaceIsTheOuterNormal) {
  const Mesh mesh = test::sphere_mesh(3);
  const Field field = Field::build(mesh.view()).value();
  for (const Triangle& t : mesh.triangles) {
    const std::array<Vec3, 3> v = corners_of(mesh, t);
    const Closest corner = field.closest(v[0]);
    EXPECT_EQ(corner.feature, Feature::vertex);
    EXPECT_GT(corner.gradient.x * v[0].x + corner.gradient.y * v[0].y + corner.gradient.z * v[0].z, 0.98);
  }
}

TEST(NotANumber, OnlyAQueryThatIsNotFiniteGivesNaN) {
  const Field field = Field::build(test::spiky_star(1, 5).view()).value();
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(),
                   infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, infinity, -infinity}) {
    for (const Vec3& p : {Vec3{bad, 0, 0}, Vec3{0, bad, 0}, Vec3{0, 0, bad}, Vec3{bad, bad, bad}}) {
      EXPECT_TRUE(std::isnan(field.distance(p)));
      EXPECT_TRUE(std::isnan(field.closest(p).distance));
      EXPECT_EQ(field.closest(p).triangle, no_index);
    }
  }
}

}  // namespace
}  // namespace cdfr
