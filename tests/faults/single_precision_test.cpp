// Float kernels lose the distance to slivers, to 2e-4 of the size, and give NaN on triangles of no area.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

#include "cdfr/field/field.h"
#include "faults/block_solid.h"
#include "faults/plain_distance.h"
#include "faults/promise.h"
#include "support/joined.h"

namespace cdfr {
namespace {

/// Slivers of that width at one end of a unit block: its faces are cut, its shape is not.
test::BlockSolid cut_block(double width) {
  test::Planes x(9);
  for (std::size_t i = 0; i < 8; ++i) x[i] = static_cast<double>(i) * width;
  x[8] = 1;
  return {x, {0, 1}, {0, 1}, [](int, int, int) { return true; }};
}

TEST(SinglePrecision, ABlockCutIntoSliversIsStillTheBlock) {
  for (const double width : {0x1p-10, 1e-6, 1e-9, 1e-12, 0x1p-60, 0x1p-150}) {
    const test::BlockSolid solid = cut_block(width);
    const Field field = Field::build(solid.mesh().view()).value();
    EXPECT_TRUE(field.report().embedded()) << width << sign_reason(field.report());
    test::expect_right(field, solid, 3000, 1);
  }
}

/// A corner that nearly lies on the opposite side: heights from 1 down to 1e-5 of a length of 3e4.
Mesh slivers(std::uint32_t count, std::uint64_t seed) {
  test::Random random(seed);
  const auto whole = [&](std::uint64_t reach) {
    return static_cast<double>(random.below(2 * reach + 1)) - static_cast<double>(reach);
  };
  Mesh mesh;
  for (std::uint32_t i = 0; i < count; ++i) {
    const Vec3 a{whole(16384), whole(16384), whole(16384)}, b{whole(16384), whole(16384), whole(16384)};
    const double t = random.between(-0.2, 1.2);
    const Vec3 c{std::nearbyint(a.x + t * (b.x - a.x)) + whole(1), std::nearbyint(a.y + t * (b.y - a.y)),
                 std::nearbyint(a.z + t * (b.z - a.z))};
    mesh.vertices.insert(mesh.vertices.end(), {a, b, c});
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return mesh;
}

TEST(SinglePrecision, SliversInAnyPositionToFourUlp) {
  const Mesh mesh = slivers(60, 2);
  BuildOptions options;
  options.sign = Sign::none;
  options.max_triangles_per_leaf = 8;
  const Field field = Field::build(mesh.view(), options).value();
  test::Random random(3);
  for (int i = 0; i < 3000; ++i) {
    Vec3 p = random.in({{-20000, -20000, -20000}, {20000, 20000, 20000}});
    if (i % 2 == 0) {
      const Vec3 v = mesh.vertices[random.below(mesh.vertices.size())];
      const double off = std::ldexp(1.0, static_cast<int>(random.below(20)) - 10);
      p = {v.x + off * random.between(-1, 1), v.y + off * random.between(-1, 1),
           v.z + off * random.between(-1, 1)};
    }
    ASSERT_TRUE(test::is_right(field, p, test::plain_distance(p, mesh)));
  }
}

/// Points, segments run along twice, and corners on the opposite side.
Mesh flat_triangles(std::uint64_t seed) {
  test::Random random(seed);
  const auto whole = [&] { return static_cast<double>(random.below(129)) - 64; };
  Mesh mesh;
  for (std::uint32_t i = 0; i < 60; ++i) {
    const Vec3 a{whole(), whole(), whole()}, e{whole(), whole(), whole()};
    const auto along = [&] {
      const auto t = static_cast<double>(random.below(4));
      return Vec3{a.x + t * e.x, a.y + t * e.y, a.z + t * e.z};
    };
    const Vec3 b = i % 3 == 0 ? a : along(), c = i % 3 == 0 ? a : along();
    mesh.vertices.insert(mesh.vertices.end(), {a, b, c});
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return mesh;
}

void expect_finite(const Closest& c) {
  ASSERT_TRUE(std::isfinite(c.distance));
  ASSERT_TRUE(test::is_finite(c.point));
  ASSERT_NEAR(test::length_of(c.gradient), 1, 1e-15);
  ASSERT_NEAR(c.barycentric[0] + c.barycentric[1] + c.barycentric[2], 1, 1e-15);
}

TEST(SinglePrecision, TrianglesOfNoAreaNeverGiveNaN) {
  const Mesh flat = flat_triangles(4);
  for (const Mesh& mesh : {flat, test::joined(flat, slivers(20, 5))}) {
    for (const Sign sign : {Sign::none, Sign::winding, Sign::pseudonormal}) {
      BuildOptions options;
      options.sign = sign;
      options.max_triangles_per_leaf = 4;
      const Field field = Field::build(mesh.view(), options).value();
      EXPECT_GE(field.report().degenerate_triangles, flat.triangles.size());
      test::Random random(6);
      for (int i = 0; i < 1000; ++i) {
        Vec3 p = random.in(test::scaled(field.bounds(), 1.5));
        if (i % 3 == 0) p = mesh.vertices[random.below(mesh.vertices.size())];
        ASSERT_NO_FATAL_FAILURE(expect_finite(field.closest(p)));
        ASSERT_NEAR(std::fabs(field.distance(p)), static_cast<double>(test::plain_distance(p, mesh)),
                    test::allowance(field.bounds(), p));
      }
    }
  }
}

}  // namespace
}  // namespace cdfr
