#include "geometry/unit_normal.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/random.h"

namespace cdfr {
namespace {

const Box unit_box{{-1, -1, -1}, {1, 1, 1}};

TEST(UnitNormal, HasUnitLengthToDoubleDouble) {
  test::Random random(4);
  for (int i = 0; i < 5000; ++i) {
    const double size = std::ldexp(1.0, static_cast<int>(random.below(390)) - 195);
    const auto point = [&] {
      const Vec3 p = random.in(unit_box);
      return Vec3{p.x * size, p.y * size, p.z * size};
    };
    const DoubleDouble3 n = unit_normal(point(), point(), point());
    const DoubleDouble excess = dot(n, n) - DoubleDouble{1, 0};
    EXPECT_LT(std::fabs(excess.hi), 0x1p-97);
  }
}

TEST(UnitNormal, IsRightForANeedleOfAspectTenToTheFifteen) {
  // Sides 1 and 2^-50 in the plane spanned by (1,1,0) and (0,0,1): the normal is (1,-1,0)/sqrt(2).
  const DoubleDouble3 n = unit_normal({0, 0, 0}, {1, 1, 0}, {1, 1, 0x1p-50});
  EXPECT_EQ(n[0].hi, std::sqrt(0.5));
  EXPECT_EQ(n[1].hi, -std::sqrt(0.5));
  EXPECT_EQ(n[2].hi, 0);
  EXPECT_EQ(n[0].lo, -n[1].lo);
}

TEST(UnitNormal, BitsDoNotDependOnTheOrderOfVertices) {
  test::Random random(5);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 a = random.in(unit_box), b = random.in(unit_box), c = random.in(unit_box);
    const DoubleDouble3 n = unit_normal(a, b, c);
    EXPECT_EQ(unit_normal(b, c, a), n);
    EXPECT_EQ(unit_normal(c, a, b), n);
    EXPECT_EQ(unit_normal(b, a, c), (DoubleDouble3{-n[0], -n[1], -n[2]}));
  }
}

TEST(UnitNormal, IsZeroForPointsOnALineAndOnlyThen) {
  EXPECT_EQ(unit_normal({1, 1, 1}, {2, 2, 2}, {4, 4, 4}), DoubleDouble3{});
  EXPECT_EQ(unit_normal({1, 2, 3}, {1, 2, 3}, {4, 5, 6}), DoubleDouble3{});
  EXPECT_TRUE(collinear({0.1, 0.1, 0.1}, {0.2, 0.2, 0.2}, {0.4, 0.4, 0.4}));
  EXPECT_FALSE(collinear({0.1, 0.1, 0.1}, {0.2, 0.2, 0.2}, {0.4, 0.4, std::nextafter(0.4, 1)}));
}

}  // namespace
}  // namespace cdfr
