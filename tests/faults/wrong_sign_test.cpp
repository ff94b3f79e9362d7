// Valid meshes on which engines give the wrong side near edges and vertices: sharp and flat wedges, caps of
// no height, spikes, saddles, vertices of high valence. No error is allowed, and the truth here is exact.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "cdfr/field/field.h"
#include "faults/star.h"
#include "support/meshes.h"

namespace cdfr {
namespace {

/// Counts the points of the grid where the sign is not that of the exact side; zero belongs to the surface
/// alone.
int wrong_signs(const Mesh& star, int count, std::uint64_t seed, const BuildOptions& options = {}) {
  EXPECT_TRUE(test::is_star(star));
  const Field field = Field::build(star.view(), options).value();
  EXPECT_TRUE(field.report().embedded()) << sign_reason(field.report());
  test::Random random(seed);
  int wrong = 0;
  for (int i = 0; i < count; ++i) {
    const Vec3 p = test::point_by_feature(star, random);
    const int side = test::exact_side(star, p);
    const double d = field.distance(p);
    wrong += side < 0 ? !(d < 0) : (side > 0 ? !(d > 0) : !(std::fabs(d) <= 0x1p-40));
  }
  return wrong;
}

TEST(WrongSign, SpikesDentsAndSaddles) {
  for (const int times : {0, 1, 2, 3}) {
    for (const std::uint64_t seed : {1U, 2U, 3U})
      EXPECT_EQ(wrong_signs(test::spiky_star(times, seed), 3000, 4), 0);
  }
}

TEST(WrongSign, AroundVerticesOfValenceAHundred) {
  EXPECT_EQ(wrong_signs(test::many_fans(104), 10000, 5), 0);
  EXPECT_EQ(wrong_signs(test::many_fans(400), 10000, 6), 0);
}

TEST(WrongSign, WedgesAndTipsOfTwoThousandths) {
  EXPECT_EQ(wrong_signs(test::flat_tetrahedron(), 10000, 7), 0);
  Mesh needle;
  needle.vertices = {{-1, -1, -1}, {1, -1, -1}, {0, 1, -1}, {0, 0, 1024}};
  needle.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  EXPECT_EQ(wrong_signs(needle, 10000, 8), 0);
}

TEST(WrongSign, WithEveryNamedPolicyAndOption) {
  const Mesh star = test::spiky_star(2, 9);
  for (const Sign sign : {Sign::automatic, Sign::pseudonormal, Sign::winding}) {
    for (const int level : {0, 4}) {
      BuildOptions options;
      options.sign = sign;
      options.max_level = level;
      options.max_triangles_per_leaf = 8;
      EXPECT_EQ(wrong_signs(star, 3000, 10, options), 0);
    }
  }
}

/// A tetrahedron with right angles at the origin. An edge of its bottom is split at vertex 4, which lies that
/// much below it, and a cap on the wall y = 0 fills the gap: convex.
Mesh capped_wedge(double drop) {
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}, {2, 0, -drop}};
  mesh.triangles = {{0, 2, 4}, {4, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {0, 4, 1}};
  return mesh;
}

/// Exact for x and y of few bits: -1 inside, 0 on the surface, 1 outside.
int side_of_capped_wedge(double drop, const Vec3& p) {
  const long double x = p.x, y = p.y, z = p.z, slope = static_cast<long double>(drop) / 2;
  const long double beyond = 4 - x - y;
  const long double least = std::min({x, y, beyond - z, z + slope * x, z + slope * beyond});
  return least > 0 ? -1 : (least < 0 ? 1 : 0);
}

TEST(WrongSign, CapsOfHeightZeroAndAlmostZero) {
  for (const double drop : {0.0, 1e-16, 0x1p-40, 1e-60, 1e-3}) {
    const Field field = Field::build(capped_wedge(drop).view()).value();
    EXPECT_TRUE(field.report().closed());
    EXPECT_EQ(field.report().embedded(), drop > 0) << sign_reason(field.report());
    test::Random random(11);
    int wrong = 0;
    for (int i = 0; i < 10000; ++i) {
      const auto coarse = [&] { return (static_cast<double>(random.below(1280)) - 128) / 256; };
      const auto tiny = [&] {
        return std::ldexp(random.between(-1, 1), -static_cast<int>(random.below(60)));
      };
      const Vec3 p{coarse(), random.below(2) == 0 ? 0 : coarse(), random.below(4) == 0 ? -drop / 2 : tiny()};
      const int side = side_of_capped_wedge(drop, p);
      const double d = field.distance(p);
      wrong += side < 0 ? !(d < 0) : (side > 0 ? !(d > 0) : !(std::fabs(d) <= 0x1p-88));
    }
    EXPECT_EQ(wrong, 0) << drop;
  }
}

}  // namespace
}  // namespace cdfr
