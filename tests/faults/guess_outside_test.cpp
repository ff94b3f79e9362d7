// Outside its box, an engine that answers with the distance to the box and a constant guesses; far away, one
// that works in float, or squares what it should not, loses the value or its sign.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>

#include "cdfr/field/field.h"
#include "faults/block_solid.h"
#include "faults/promise.h"
#include "faults/star.h"
#include "support/meshes.h"
#include "support/same.h"

namespace cdfr {
namespace {

/// An L: its hollow is far from the box, so that a distance to the box is no answer.
test::BlockSolid angle_iron() {
  return {{0, 0.1, 1}, {0, 0.1, 1}, {0, 2}, [](int i, int j, int) { return i == 0 || j == 0; }};
}

Vec3 direction(std::uint64_t which) {
  const auto part = [&](std::uint64_t n) { return static_cast<double>(n % 3) - 1; };
  return {part(which), part(which / 3), part(which / 9)};
}

TEST(GuessOutside, IsTheDistanceToTheMeshAndNotToTheBox) {
  const test::BlockSolid solid = angle_iron();
  for (const double margin : {0.0, 0.05, 1.0}) {
    BuildOptions options;
    options.margin = margin;
    options.max_triangles_per_leaf = 1;
    options.max_level = 2;
    const Field field = Field::build(solid.mesh().view(), options).value();
    test::Random random(1);
    for (const double factor : {1.001, 1.5, 4.0, 100.0}) {
      const Box around = test::scaled(field.domain(), factor);
      for (int i = 0; i < 500; ++i) {
        Vec3 p = random.in(around);
        (i % 3 == 0 ? p.x : (i % 3 == 1 ? p.y : p.z)) = i % 2 == 0 ? around.hi.y : around.lo.y;
        ASSERT_TRUE(test::is_right(field, p, solid.distance(p)));
      }
    }
  }
}

TEST(GuessOutside, DoesNotJumpWhereTheDomainEnds) {
  const Mesh mesh = test::spiky_star(2, 4);
  const Field field = Field::build(mesh.view()).value();
  const Box domain = field.domain();
  test::Random random(2);
  for (int i = 0; i < 2000; ++i) {
    Vec3 in = random.in(domain), out = in;
    in.x = std::nextafter(domain.hi.x, 0.0);
    out.x = std::nextafter(domain.hi.x, 1e9);
    ASSERT_NEAR(field.distance(in), field.distance(out), 10 * test::ulp_of(test::largest_of(out)));
  }
}

TEST(GuessOutside, IsRightAtAnySize) {
  const test::BlockSolid solid = angle_iron();
  const Field field = Field::build(solid.mesh().view()).value();
  for (const double size : {1e3, 1e9, 1e30, 1e77, 1e100, 1e155, 1e200, 1e300}) {
    for (std::uint64_t which = 0; which < 27; ++which) {
      const Vec3 d = direction(which);
      if (d == Vec3{}) continue;
      const Vec3 p{0.3 + d.x * size, 0.4 + 0.7 * d.y * size, 0.5 + 0.01 * d.z * size};
      ASSERT_TRUE(test::is_right(field, p, solid.distance(p))) << size;
      const Closest c = field.closest(p);
      EXPECT_TRUE(test::is_finite(c.point));
      EXPECT_LE(std::fabs(field.distance(c.point)), 1e-15);
    }
  }
}

/// From far away the gradient points away from the mesh and the nearest point is one that brute force finds.
TEST(GuessOutside, NamesTheSamePointAsBruteForce) {
  const Mesh mesh = test::spiky_star(2, 5);
  const Field field = Field::build(mesh.view()).value();
  const BruteForce brute = BruteForce::over(mesh.view()).value();
  test::Random random(3);
  for (const double size : {2e3, 1e4, 1e9, 1e18, 1e30, 1e200}) {
    for (int i = 0; i < 100; ++i) {
      const Vec3 d = random.in({{-1, -1, -1}, {1, 1, 1}}), p{d.x * size, d.y * size, d.z * size};
      const Closest c = field.closest(p);
      ASSERT_TRUE(test::same_bits(c, brute.closest(p))) << size;
      if (size < 1e9) continue;
      const Vec3 g = c.gradient;
      EXPECT_NEAR((g.x * d.x + g.y * d.y + g.z * d.z) / test::length_of(d), 1, 1e-9);
    }
  }
}

/// Larger than any double is infinite; nothing is NaN.
TEST(GuessOutside, TheLargestNumbersGiveNoNaN) {
  const Field field = Field::build(angle_iron().mesh().view()).value();
  constexpr double most = std::numeric_limits<double>::max();
  for (std::uint64_t which = 0; which < 27; ++which) {
    const Vec3 d = direction(which);
    if (d == Vec3{}) continue;
    const Closest c = field.closest({d.x * most, d.y * most, d.z * most});
    EXPECT_GE(c.distance, most / 2);
    EXPECT_NEAR(test::length_of(c.gradient), 1, 1e-15);
    EXPECT_TRUE(test::is_finite(c.point));
  }
}

}  // namespace
}  // namespace cdfr
