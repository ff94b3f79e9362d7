#include "core/arithmetic.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>

namespace cdfr {
namespace {

using Wide = long double;
static_assert(std::numeric_limits<Wide>::digits >= 64, "the comparison needs more digits than double has");

double ulp(double x) {
  const double size = std::abs(x);
  return std::nextafter(size, std::numeric_limits<double>::infinity()) - size;
}

double error_in_ulp(double value, Wide truth) {
  return static_cast<double>(std::abs(static_cast<Wide>(value) - truth) / ulp(static_cast<double>(truth)));
}

TEST(Arithmetic, SineAndCosineAreWithinOneUlp) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> exponent(-60, 20);
  double worst = 0;
  for (int i = 0; i < 400000; ++i) {
    double x = std::exp2(exponent(random));
    if (i % 2 != 0) x = -x;
    worst = std::max(worst, error_in_ulp(sine(x), std::sin(static_cast<Wide>(x))));
    worst = std::max(worst, error_in_ulp(cosine(x), std::cos(static_cast<Wide>(x))));
  }
  RecordProperty("worst_in_ulp", std::to_string(worst));
  EXPECT_LT(worst, 1.0);
}

TEST(Arithmetic, SineNearMultiplesOfARightAngle) {
  double worst = 0;
  for (int k = 1; k < 667544; k += 7) {
    const double x = static_cast<double>(k) * (std::acos(-1.0) / 2);
    for (const double y : {std::nextafter(x, 0.0), x, std::nextafter(x, 1e9)}) {
      if (y > 1048576) continue;
      worst = std::max(worst, error_in_ulp(sine(y), std::sin(static_cast<Wide>(y))));
      worst = std::max(worst, error_in_ulp(cosine(y), std::cos(static_cast<Wide>(y))));
    }
  }
  EXPECT_LT(worst, 1.0);
}

TEST(Arithmetic, SineOfSpecialValues) {
  EXPECT_EQ(sine(0), 0);
  EXPECT_TRUE(std::signbit(sine(-0.0)));
  EXPECT_EQ(cosine(0), 1);
  EXPECT_EQ(sine(0x1p-1074), 0x1p-1074);
  EXPECT_FALSE(std::isnan(sine(0x1p20)));
  EXPECT_TRUE(std::isnan(sine(0x1.0000000000001p20)));
  EXPECT_TRUE(std::isnan(cosine(std::numeric_limits<double>::infinity())));
  EXPECT_TRUE(std::isnan(cosine(std::numeric_limits<double>::quiet_NaN())));
}

TEST(Arithmetic, SineIsOddAndCosineEven) {
  for (double x = 0.001; x < 1e6; x *= 1.01) {
    EXPECT_EQ(sine(-x), -sine(x));
    EXPECT_EQ(cosine(-x), cosine(x));
  }
}

TEST(Arithmetic, ArctangentIsWithinFourUlp) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> exponent(-300, 300);
  std::uniform_real_distribution<double> ratio(-4, 4);
  double worst = 0;
  for (int i = 0; i < 400000; ++i) {
    const double size = std::exp2(exponent(random));
    const double y = size * ((i & 1) != 0 ? 1 : -1);
    const double x = size * std::exp2(ratio(random) * (i % 8 == 0 ? 100 : 1)) * ((i & 2) != 0 ? 1 : -1);
    worst = std::max(worst,
                     error_in_ulp(arctangent2(y, x), std::atan2(static_cast<Wide>(y), static_cast<Wide>(x))));
  }
  RecordProperty("worst_in_ulp", std::to_string(worst));
  EXPECT_LT(worst, 4.0);
}

TEST(Arithmetic, ArctangentRunsContinuouslyThroughItsTable) {
  for (int k = 0; k <= 16; ++k) {
    const double q = k / 16.0;
    EXPECT_LE(arctangent2(std::nextafter(q, 0.0), 1), arctangent2(q, 1) + 4 * ulp(q)) << q;
    EXPECT_LT(error_in_ulp(arctangent2(q, 1), std::atan(static_cast<Wide>(q))), 4.0) << q;
  }
}

TEST(Arithmetic, ArctangentOfSpecialValues) {
  const double pi = arctangent2(0.0, -1.0);
  EXPECT_EQ(pi, 0x1.921fb54442d18p+1);
  EXPECT_EQ(arctangent2(-0.0, -1.0), -pi);
  EXPECT_EQ(arctangent2(0.0, -0.0), pi);
  EXPECT_EQ(arctangent2(0.0, 0.0), 0.0);
  EXPECT_TRUE(std::signbit(arctangent2(-0.0, 1.0)));
  EXPECT_EQ(arctangent2(1.0, 0.0), pi / 2);
  EXPECT_EQ(arctangent2(-1.0, 0.0), -pi / 2);
  EXPECT_EQ(arctangent2(3.0, 3.0), pi / 4);
  EXPECT_TRUE(std::isnan(arctangent2(std::numeric_limits<double>::quiet_NaN(), 1)));
  EXPECT_TRUE(std::isnan(arctangent2(1, std::numeric_limits<double>::quiet_NaN())));
  EXPECT_TRUE(std::isnan(arctangent2(std::numeric_limits<double>::infinity(), 1)));
}

TEST(Arithmetic, AngleBetweenOfZeroAndOfEqualVectors) {
  EXPECT_EQ(angle_between({}, {1, 2, 3}), 0);
  EXPECT_EQ(angle_between({}, {}), 0);
  const Vec3 v{0.1, -0.7, 1e-30};
  EXPECT_EQ(angle_between(v, v), 0);
  EXPECT_EQ(angle_between(v, {-v.x, -v.y, -v.z}), 0x1.921fb54442d18p+1);
  EXPECT_EQ(angle_between({1, 0, 0}, {0, 5, 0}), 0x1.921fb54442d18p+0);
}

/// Integer vectors in a plane: cross and dot product are known exactly.
TEST(Arithmetic, AngleBetweenNearlyParallelVectors) {
  __extension__ using Integer = __int128;
  std::mt19937_64 random(3);
  double worst = 0;
  for (int i = 0; i < 200000; ++i) {
    const auto a = static_cast<std::int64_t>(random() >> 12U);
    const auto b = static_cast<std::int64_t>(random() >> 12U);
    const std::int64_t reach = std::int64_t{1} << (i % 50);
    const std::int64_t c = a + static_cast<std::int64_t>(random() % (2 * reach)) - reach;
    const std::int64_t d = b + static_cast<std::int64_t>(random() % (2 * reach)) - reach;
    const Integer cross = static_cast<Integer>(a) * d - static_cast<Integer>(b) * c;
    const Integer dot = static_cast<Integer>(a) * c + static_cast<Integer>(b) * d;
    if (cross == 0) continue;
    const Wide truth = std::atan2(std::abs(static_cast<Wide>(cross)), static_cast<Wide>(dot));
    const double angle = angle_between({0, static_cast<double>(a), static_cast<double>(b)},
                                       {0, static_cast<double>(c), static_cast<double>(d)});
    worst = std::max(worst, static_cast<double>(std::abs(angle - truth) / truth));
  }
  RecordProperty("worst_relative", std::to_string(worst * 0x1p53));
  EXPECT_LT(worst, 16 * 0x1p-53);
}

TEST(Arithmetic, AngleBetweenSurvivesExtremeSizes) {
  for (const double up : {0x1p-200, 0x1p-100, 1.0, 0x1p100, 0x1p200}) {
    for (const double along : {0x1p-200, 1.0, 0x1p200}) {
      const Vec3 u{along, 0, 0};
      const Vec3 v{along, 0, up};
      const Wide truth = std::atan2(static_cast<Wide>(up), static_cast<Wide>(along));
      EXPECT_LT(std::abs(angle_between(u, v) - truth) / truth, 16 * 0x1p-53) << up << " " << along;
      EXPECT_EQ(angle_between(u, v), angle_between(v, u));
    }
  }
}

/// Bits that every machine must give; a change here changes files and checksums everywhere.
TEST(Arithmetic, BitsAreFixed) {
  std::uint64_t hash = 0;
  for (int i = -20000; i < 20000; ++i) {
    const double x = 0.37 * i;
    for (const double value :
         {sine(x), cosine(x), arctangent2(x, 3.0 - x), angle_between({x, 1, 2}, {3, x, 1})}) {
      hash = (hash ^ std::bit_cast<std::uint64_t>(value)) * 0x9e3779b97f4a7c15U;
      hash ^= hash >> 29U;
    }
  }
  EXPECT_EQ(hash, 6685614314466925590U);
}

}  // namespace
}  // namespace cdfr
