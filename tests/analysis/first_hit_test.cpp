// The ray method: closed forms, what counts as a hit, and cones.
#include "analysis/first_hit.h"

#include <gtest/gtest.h>

#include <cmath>

#include "analysis/largest_ball.h"
#include "analysis/shapes.h"
#include "analysis/triangle_edges.h"
#include "cdfr/analysis/thickness.h"
#include "support/meshes.h"
#include "support/random.h"

namespace cdfr {
namespace {

class FirstHitOfShape : public testing::TestWithParam<std::size_t> {};
INSTANTIATE_TEST_SUITE_P(All, FirstHitOfShape, testing::Range(std::size_t{0}, test::shapes(0.1).size()));

TEST_P(FirstHitOfShape, HasItsClosedForm) {
  const test::Shape shape = test::shapes(0.01)[GetParam()];
  SCOPED_TRACE(shape.name);
  const Field field = Field::build(shape.mesh.view()).value();
  const auto slots = slots_by_number(field.data().triangles);
  for (const test::Place& place : shape.places) {
    const Closest on_mesh = field.closest(place.point);
    const Vec3 inward{-place.normal.x, -place.normal.y, -place.normal.z};
    const RayOptions options{1, 0, 100, ball_rounding(field.data(), 100)};
    const MeasuredWall wall =
        shortest_ray(field.data(), {on_mesh.point, inward, slots[on_mesh.triangle]}, options);
    // Both ends are on the mesh, each within its error, and the ray may meet the far one at a slant.
    EXPECT_NEAR(wall.thickness, place.ray, 6 * shape.error + 1e-9);
    EXPECT_LT(wall.error, 1e-9);
    EXPECT_LT(std::fabs(field.distance(wall.opposite_point)), 1e-9);
  }
}

/// Against every triangle, one by one, in long double.
TEST(FirstHit, IsTheFirstOfAll) {
  const Mesh mesh = test::soup(60, {{0, 0, 0}, {1, 1, 1}}, 5);
  const Field field = Field::build(mesh.view()).value();
  const auto slots = slots_by_number(field.data().triangles);
  test::Random random(9);
  std::size_t hits = 0;
  for (int i = 0; i < 400; ++i) {
    const Vec3 p = random.in({{-0.2, -0.2, -0.2}, {1.2, 1.2, 1.2}});
    Vec3 d = random.in({{-1, -1, -1}, {1, 1, 1}});
    const double length = std::hypot(d.x, d.y, d.z);
    d = {d.x / length, d.y / length, d.z / length};
    double least = INFINITY;
    for (const Triangle& t : mesh.triangles) {
      const Vec3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
      const auto determinant = [](const Vec3& u, const Vec3& v, const Vec3& w) {
        return static_cast<long double>(u.x) * (v.y * w.z - v.z * w.y) + u.y * (v.z * w.x - v.x * w.z) +
               u.z * (v.x * w.y - v.y * w.x);
      };
      const auto minus = [](const Vec3& u, const Vec3& v) { return Vec3{u.x - v.x, u.y - v.y, u.z - v.z}; };
      const Vec3 u = minus(a, p), v = minus(b, p), w = minus(c, p);
      const long double uv = determinant(d, u, v), vw = determinant(d, v, w), wu = determinant(d, w, u);
      if (!((uv > 0 && vw > 0 && wu > 0) || (uv < 0 && vw < 0 && wu < 0))) continue;
      const double way = static_cast<double>(determinant(u, v, w) / (uv + vw + wu));
      if (way > 0) least = std::min(least, way);
    }
    const MeasuredWall wall = shortest_ray(field.data(), {p, d, no_index}, {1, 0, 10, 1e-14});
    ASSERT_EQ(std::isnan(wall.thickness), std::isinf(least));
    if (std::isinf(least)) continue;
    ++hits;
    ASSERT_NEAR(wall.thickness, least, wall.error + 1e-12);
  }
  EXPECT_GT(hits, 100U);
}

/// At an edge of the far side's tessellation, and along it.
TEST(FirstHit, MeetsEdgesAndVertices) {
  const Field field = Field::build(test::box_mesh({{0, 0, 0}, {4, 4, 1}}).view()).value();
  for (const Vec3& p : {Vec3{2, 2, 0}, Vec3{1, 3, 0}, Vec3{1, 1, 0}, Vec3{0.5, 2, 0}}) {
    const MeasuredWall wall = shortest_ray(field.data(), {p, {0, 0, 1}, no_index}, {1, 0, 10, 1e-14});
    EXPECT_NEAR(wall.thickness, 1, 1e-12);
  }
  const MeasuredWall along = shortest_ray(field.data(), {{2, 2, 0}, {0, 0, -1}, no_index}, {1, 0, 10, 1e-14});
  EXPECT_TRUE(std::isnan(along.thickness));
}

TEST(FirstHit, InATrianglesPlaneIsItsBorder) {
  Mesh mesh;
  mesh.vertices = {{1, -1, 0}, {3, -1, 0}, {2, 2, 0}};
  mesh.triangles = {{0, 1, 2}};
  const Field field = Field::build(mesh.view()).value();
  const MeasuredWall wall = shortest_ray(field.data(), {{0, 0, 0}, {1, 0, 0}, no_index}, {1, 0, 10, 1e-14});
  EXPECT_LE(wall.error, 1e-12);
  EXPECT_NEAR(wall.thickness, 4.0 / 3, wall.error);
  const MeasuredWall beside =
      shortest_ray(field.data(), {{0, 2.5, 0}, {1, 0, 0}, no_index}, {1, 0, 10, 1e-14});
  EXPECT_TRUE(std::isnan(beside.thickness));
  const MeasuredWall behind = shortest_ray(field.data(), {{5, 0, 0}, {1, 0, 0}, no_index}, {1, 0, 10, 1e-14});
  EXPECT_TRUE(std::isnan(behind.thickness));
}

TEST(FirstHit, OfAConeIsTheShortest) {
  const Field field = Field::build(test::box_mesh({{0, 0, 0}, {4, 4, 1}}).view()).value();
  ThicknessOptions options;
  options.method = ThicknessMethod::ray;
  const Thickness single = thickness(field, options).value();
  options.cone = 60;
  options.rays = 64;
  const Thickness cone = thickness(field, options).value();
  ASSERT_EQ(cone.samples.size(), single.samples.size());
  bool shorter = false;
  for (std::size_t i = 0; i < cone.samples.size(); ++i) {
    EXPECT_LE(cone.samples[i].thickness, single.samples[i].thickness);
    shorter |= cone.samples[i].thickness < 0.9 * single.samples[i].thickness;
    const Vec3 &p = cone.samples[i].position, &q = cone.samples[i].opposite_point;
    EXPECT_NEAR(std::hypot(p.x - q.x, p.y - q.y, p.z - q.z), cone.samples[i].thickness, 1e-9);
  }
  EXPECT_TRUE(shorter) << "the long way through the plate is cut short by its sides";
  EXPECT_EQ(cone.report.queries, 64 * cone.samples.size());
}

}  // namespace
}  // namespace cdfr
