/// The oracle's inside test against bodies whose inside is plain.
#include "oracle/exact_side.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "oracle/random.h"

namespace cdfr::oracle {
namespace {

/// Box from lo to hi, two triangles a side, fronts outward.
Mesh box(Vec3 lo, Vec3 hi) {
  Mesh mesh;
  for (unsigned i = 0; i < 8; ++i) {
    mesh.vertices.push_back({(i & 1U) ? hi.x : lo.x, (i & 2U) ? hi.y : lo.y, (i & 4U) ? hi.z : lo.z});
  }
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

void append(Mesh& mesh, const Mesh& other) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
  for (const Triangle& t : other.triangles)
    mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
}

TEST(ExactSide, of_a_box_is_that_of_its_inequalities) {
  const Mesh mesh = box({-1, -2, -3}, {1, 2, 3});
  Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const auto coordinate = [&](double half) {
      // Often exactly on a face's plane, one ulp beside it, or zero.
      constexpr double beyond = 5;
      const double s = random.below(2) == 0 ? 1 : -1;
      switch (random.below(5)) {
        case 0:
          return s * half;
        case 1:
          return s * std::nextafter(half, 0.0);
        case 2:
          return s * std::nextafter(half, beyond);
        case 3:
          return 0.0;
        default:
          return s * 1.5 * half * random.unit();
      }
    };
    const Vec3 p{coordinate(1), coordinate(2), coordinate(3)};
    const bool outside = std::abs(p.x) > 1 || std::abs(p.y) > 2 || std::abs(p.z) > 3;
    const bool inside = std::abs(p.x) < 1 && std::abs(p.y) < 2 && std::abs(p.z) < 3;
    EXPECT_EQ(exact_side(mesh.view(), p), outside ? 1 : inside ? -1 : 0) << p.x << ' ' << p.y << ' ' << p.z;
  }
}

/// The corner of the box to which a direction points, moved along the axes whose bit is set in `axes` by
/// whole steps into the box's side: a point of the corner, of an edge at it, or of a face.
Vec3 ahead(Random& random, Vec3 d, double half, unsigned axes) {
  const auto coordinate = [&](double along, bool moved) {
    const double corner = along > 0 ? half : -half;
    return moved ? corner - std::copysign(static_cast<double>(1 + random.below(1 << 20)), along) : corner;
  };
  const double x = coordinate(d.x, (axes & 1U) != 0);
  const double y = coordinate(d.y, (axes & 2U) != 0);
  return {x, y, coordinate(d.z, (axes & 4U) != 0)};
}

TEST(ExactSide, takes_another_ray_where_the_first_meets_an_edge_or_a_corner) {
  constexpr double half = 0x1p23;
  const Mesh mesh = box({-half, -half, -half}, {half, half, half});
  const Vec3 d = ray_direction(0);
  Random random(3);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 target = ahead(random, d, half, static_cast<unsigned>(i) % 4);
    // The ray from here passes through the target exactly; one ulp aside it misses it by as little as can be.
    const double back = static_cast<double>(1 + random.below(4));
    Vec3 p{target.x - back * d.x, target.y - back * d.y, target.z - back * d.z};
    if (i % 2 == 0) p.x = std::nextafter(p.x, random.below(2) == 0 ? -half : half);
    if (i % 3 == 0) p.z = std::nextafter(p.z, random.below(2) == 0 ? -half : half);
    const double reach = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    if (reach == half) continue;
    EXPECT_EQ(exact_winding(mesh.view(), p), reach < half ? 1 : 0);
  }
}

TEST(ExactSide, holds_far_from_the_origin_and_at_any_scale) {
  for (const double scale : {0x1p-190, 1.0, 0x1p190}) {
    const Mesh mesh = box({0, 0, 0}, {scale, scale, scale});
    const double half = scale / 2;
    EXPECT_EQ(exact_side(mesh.view(), {half, half, half}), -1);
    EXPECT_EQ(exact_side(mesh.view(), {half, half, std::nextafter(scale, 2 * scale)}), 1);
    EXPECT_EQ(exact_side(mesh.view(), {half, half, 5e-324}), -1);
    EXPECT_EQ(exact_side(mesh.view(), {half, half, -5e-324}), 1);
    EXPECT_EQ(exact_side(mesh.view(), {half, half, 0}), 0);
    EXPECT_EQ(exact_side(mesh.view(), {1e300, 0, -1e300}), 1);
  }
  const Mesh far = box({1e15, 1e15, 1e15}, {1e15 + 1, 1e15 + 1, 1e15 + 1});
  EXPECT_EQ(exact_side(far.view(), {1e15 + 0.5, 1e15 + 0.5, 1e15 + 0.5}), -1);
  EXPECT_EQ(exact_side(far.view(), {1e15 + 0.5, 1e15 + 0.5, 1e15 + 1.125}), 1);
}

TEST(ExactSide, counts_how_often_the_surface_winds) {
  Mesh mesh = box({-4, -4, -4}, {4, 4, 4});
  Mesh cavity = box({-2, -2, -2}, {2, 2, 2});
  for (Triangle& t : cavity.triangles) std::swap(t[1], t[2]);
  append(mesh, cavity);
  EXPECT_EQ(exact_winding(mesh.view(), {3, 0, 0}), 1);
  EXPECT_EQ(exact_winding(mesh.view(), {0, 0, 0}), 0);
  EXPECT_EQ(exact_winding(mesh.view(), {2, 0, 0}), std::nullopt);
  append(mesh, box({-1, -1, -1}, {1, 1, 5}));
  EXPECT_EQ(exact_winding(mesh.view(), {0, 0, 0}), 1);
  EXPECT_EQ(exact_winding(mesh.view(), {0.5, 0.25, 3}), 2);
  EXPECT_EQ(exact_winding(mesh.view(), {0, 0, 4.5}), 1);
}

TEST(ExactSide, is_not_disturbed_by_triangles_of_no_area) {
  Mesh mesh = box({-1, -1, -1}, {1, 1, 1});
  mesh.triangles.push_back({0, 0, 0});
  // Split the side 4-5-7 along its edge 4-5 by a face without area whose neighbour meets it in two pieces.
  mesh.vertices.push_back({0, -1, 1});
  mesh.triangles[2] = {4, 8, 7};
  mesh.triangles.push_back({8, 5, 7});
  mesh.triangles.push_back({4, 5, 8});
  EXPECT_EQ(exact_side(mesh.view(), {0, 0, 0}), -1);
  EXPECT_EQ(exact_side(mesh.view(), {0, -0.5, 0.5}), -1);
  EXPECT_EQ(exact_side(mesh.view(), {0, -1.5, 1}), 1);
  EXPECT_EQ(exact_side(mesh.view(), {0.25, -1, 1}), 0);
}

/// A star-shaped body around the origin, as a fan of thin triangles from two poles: p is inside iff it is
/// nearer to the origin than the surface along its own direction.
TEST(ExactSide, of_a_double_cone_of_needles_is_that_of_its_profile) {
  Mesh mesh;
  constexpr unsigned teeth = 150;
  mesh.vertices = {{0, 0, 1}, {0, 0, -1}};
  Random random(2);
  for (unsigned i = 0; i < teeth; ++i) {
    // Rational points of the unit circle, in the order of their angle.
    const double t = 2.0 * i / teeth - 1;
    const double square = 1 + t * t;
    mesh.vertices.push_back({(1 - t * t) / square, 2 * t / square, 0});
  }
  mesh.vertices.push_back({-1, 0, 0});
  for (unsigned i = 0; i <= teeth; ++i) {
    const unsigned next = i == teeth ? 2 : 3 + i;
    mesh.triangles.push_back({0, 2 + i, next});
    mesh.triangles.push_back({1, next, 2 + i});
  }
  for (int i = 0; i < 100; ++i) {
    const Vec3 d = random.direction();
    const double rim = std::sqrt(d.x * d.x + d.y * d.y);
    const double reach = 1 / (rim + std::abs(d.z));
    // The polygon's chords stay between 0.7 and 1 times the circle's radius.
    EXPECT_EQ(exact_side(mesh.view(), {0.65 * reach * d.x, 0.65 * reach * d.y, 0.65 * reach * d.z}), -1);
    EXPECT_EQ(exact_side(mesh.view(), {1.01 * reach * d.x, 1.01 * reach * d.y, 1.01 * reach * d.z}), 1);
  }
}

}  // namespace
}  // namespace cdfr::oracle
