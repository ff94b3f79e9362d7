#include "octree/influence.h"

#include <gtest/gtest.h>

#include <cmath>

#include "geometry/point_triangle.h"
#include "geometry/unit_normal.h"
#include "support/random.h"

namespace cdfr {
namespace {

const Lattice unit_lattice{{0, 0, 0}, 1, {1, 1, 1}};

std::array<Vec3, 8> unit_corners() {
  std::array<Vec3, 8> corners;
  for (std::size_t i = 0; i < 8; ++i) {
    corners[i] = {i & 1 ? 1.0 : 0.0, i & 2 ? 1.0 : 0.0, i & 4 ? 1.0 : 0.0};
  }
  return corners;
}

double distance(const Vec3& p, const std::array<Vec3, 3>& t) {
  return square_root(measure(p, {t, unit_normal(t[0], t[1], t[2])}).squared);
}

/// Where a dropped triangle is at least as close as the dominator, the rule has lied. Corners, faces and the
/// inside are tried.
TEST(CornerDominance, NeverDropsWhatWinsSomewhereInTheCell) {
  test::Random random(11);
  const Box around{{-1.5, -1.5, -1.5}, {2.5, 2.5, 2.5}};
  int dropped = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vec3 q = random.in(around);
    const Vec3 a = random.in(around);
    const double size = std::ldexp(2.0, -static_cast<int>(random.below(6)));
    const auto near = [&] {
      return random.in({{a.x - size, a.y - size, a.z - size}, {a.x + size, a.y + size, a.z + size}});
    };
    const std::array<Vec3, 3> t{a, near(), near()};
    Dominators dominators;
    dominators.fill(q);
    const CornerDominance rule(unit_lattice, unit_corners(), dominators);
    std::array<double, 8> squared;
    for (std::size_t c = 0; c < 8; ++c) squared[c] = std::pow(distance(unit_corners()[c], t), 2);
    if (!rule.drops(squared)) continue;
    ++dropped;
    for (int k = 0; k < 20; ++k) {
      Vec3 p = random.in({{0, 0, 0}, {1, 1, 1}});
      if (k % 2 == 0) p.x = std::round(p.x);
      if (k % 4 == 0) p.y = std::round(p.y);
      ASSERT_GT(distance(p, t), std::hypot(p.x - q.x, p.y - q.y, p.z - q.z));
    }
  }
  EXPECT_GT(dropped, 1000);
}

TEST(CornerDominance, IsExactForASinglePoint) {
  // A point T against a point q: the corner where T does best decides, up to rounding.
  const Vec3 q{-1, 0.5, 0.5};
  Dominators dominators;
  dominators.fill(q);
  const CornerDominance rule(unit_lattice, unit_corners(), dominators);
  const auto drops = [&](double x) {
    std::array<double, 8> squared;
    for (std::size_t c = 0; c < 8; ++c) {
      const Vec3 p = unit_corners()[c];
      squared[c] = (p.x - x) * (p.x - x) + (p.y - 0.5) * (p.y - 0.5) + (p.z - 0.5) * (p.z - 0.5);
    }
    return rule.drops(squared);
  };
  EXPECT_FALSE(drops(2.999999));  // wins near x = 1
  EXPECT_TRUE(drops(3.000001));
  EXPECT_FALSE(drops(-1));  // a tie is kept: dominance is strict
}

TEST(CornerDominance, LanesAgreeWithSingles) {
  test::Random random(12);
  const Box around{{-1, -1, -1}, {2, 2, 2}};
  for (int i = 0; i < 2000; ++i) {
    Dominators dominators;
    for (Vec3& q : dominators) q = random.in(around);
    std::array<CornerDominance, 8> rules;
    rules.fill(CornerDominance(unit_lattice, unit_corners(), dominators));
    SampleDistances distances;
    for (GroupDistances& squared : distances.squared) {
      for (double& d : squared) d = random.between(0, 6);
    }
    const auto lanes = static_cast<std::uint8_t>(random.below(256));
    std::array<KeptLanes, 8> kept;
    sift_lanes(rules, distances, lanes, 0xff, kept);
    for (std::size_t child = 0; child < 8; ++child) {
      KeptLanes expected;
      for (std::size_t lane = 0; lane < group_size; ++lane) {
        std::array<double, 8> squared;
        for (std::size_t c = 0; c < 8; ++c) squared[c] = distances.squared[corner_sample(child, c)][lane];
        if ((lanes >> lane & 1) == 0 || rules[child].drops(squared)) continue;
        expected.lanes |= static_cast<std::uint8_t>(1U << lane);
        ++expected.count;
        expected.least_squared =
            std::min(expected.least_squared, distances.squared[centre_sample(child)][lane]);
        for (std::size_t c = 0; c < 8; ++c) {
          expected.corners_squared[c] = std::min(expected.corners_squared[c], squared[c]);
        }
      }
      EXPECT_EQ(kept[child].lanes, expected.lanes);
      EXPECT_EQ(kept[child].count, expected.count);
      EXPECT_EQ(kept[child].least_squared, expected.least_squared);
      EXPECT_EQ(kept[child].corners_squared, expected.corners_squared);
    }
  }
}

}  // namespace
}  // namespace cdfr
