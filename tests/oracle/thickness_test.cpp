// Wall thickness of real parts against brute force: every triangle for every question, and bisection.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "cdfr/analysis/thickness.h"
#include "oracle/random.h"
#include "oracle/random_solids.h"
#include "oracle/real_parts.h"
#include "oracle/vectors.h"
#include "oracle/wall_oracle.h"

namespace cdfr::oracle {
namespace {

class RealWalls : public testing::TestWithParam<Model> {
 protected:
  /// Samples here and there, as many as brute force looks at in a second.
  std::vector<std::size_t> some(const Thickness& walls) const {
    Random random(17);
    std::vector<std::size_t> chosen(std::clamp(4'000'000 / mesh.triangles.size(), 30UL, 1500UL));
    for (std::size_t& i : chosen) i = random.below(walls.samples.size());
    return chosen;
  }
  double ulp() const {
    const Box b = field.bounds();
    const double largest = std::max({std::fabs(b.lo.x), std::fabs(b.lo.y), std::fabs(b.lo.z),
                                     std::fabs(b.hi.x), std::fabs(b.hi.y), std::fabs(b.hi.z)});
    return std::ldexp(1.0, std::ilogb(largest) - 52);
  }

  const Mesh mesh = load(GetParam()).value();
  const Field field = Field::build(mesh.view()).value();
  const BruteForce brute = BruteForce::over(mesh.view()).value();
};
INSTANTIATE_TEST_SUITE_P(Parts, RealWalls, testing::ValuesIn(real_parts()),
                         [](const auto& model) { return model.param.name; });
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(RealWalls);

// The ball of the thickness fits, and that of thickness and error, larger by rounding, does not: as r - depth
// grows with r, that is all there is to show. Where the ball touches it is as far from the centre as its
// radius, less D.
TEST_P(RealWalls, BallsFitAndNoLargerOnesDo) {
  for (const double facet : {-1.0, 0.002}) {
    ThicknessOptions options;
    options.facet = facet < 0 ? facet : facet * length(minus(field.bounds().hi, field.bounds().lo));
    const Thickness walls = thickness(field, options).value();
    ASSERT_LE(walls.samples.size(), mesh.triangles.size());  // those without area have no sample
    ASSERT_GE(walls.samples.size(), mesh.triangles.size() * 9 / 10);
    const double doubt = 32 * ulp();
    for (const std::size_t i : some(walls)) {
      const ThicknessSample& s = walls.samples[i];
      const double d = s.facet;
      SCOPED_TRACE(testing::Message()
                   << "sample " << i << " D " << d << " thickness " << s.thickness << " + " << s.error);
      const auto excess = [&](double r) {
        return r + brute.closest(plus(s.position, -r, s.normal)).distance - d;
      };
      ASSERT_LE(s.error, walls.report.error + 2 * ulp());
      ASSERT_LE(excess(s.thickness / 2), doubt);
      ASSERT_GE(excess((s.thickness + s.error) / 2 + 4 * ulp()), -doubt);
      const double held = length(minus(plus(s.position, -s.thickness / 2, s.normal), s.opposite_point));
      EXPECT_GE(held, s.thickness / 2 - d - doubt);
      EXPECT_LE(std::fabs(brute.closest(s.opposite_point).distance), doubt);
    }
  }
}

TEST_P(RealWalls, BallsAgreeWithBisection) {
  const Thickness walls = thickness(field).value();
  const double largest = length(minus(field.bounds().hi, field.bounds().lo));
  for (const std::size_t i : some(walls)) {
    const ThicknessSample& s = walls.samples[i];
    const Range truth = ball_diameter([&](const Vec3& p) { return -field.distance(p); },
                                      {s.position, s.normal, s.facet, largest, 32 * ulp()});
    EXPECT_TRUE(truth.meets(s.thickness, s.thickness + s.error))
        << "sample " << i << ": " << s.thickness << " + " << s.error << " not in " << truth.low << " to "
        << truth.high;
  }
}

TEST_P(RealWalls, RaysEndAtTheFirstTriangle) {
  ThicknessOptions options;
  options.method = ThicknessMethod::ray;
  options.largest = 2 * length(minus(field.bounds().hi, field.bounds().lo));
  const Thickness walls = thickness(field, options).value();
  for (const std::size_t i : some(walls)) {
    const ThicknessSample& s = walls.samples[i];
    const Range truth = first_hit(mesh.view(), s.position, s.normal, s.triangle);
    // What touches the sample itself does not count: it is met at once, if at all.
    if (truth.low <= 64 * ulp()) continue;
    EXPECT_TRUE(truth.meets(s.thickness - s.error - 4 * ulp(), s.thickness + s.error + 4 * ulp()))
        << "sample " << i << " of triangle " << s.triangle << ": " << s.thickness << " not in " << truth.low
        << " to " << truth.high;
  }
}

TEST_P(RealWalls, NoBallIsLargerThanTheDeepest) {
  const Thickness walls = thickness(field).value();
  const Deepest deepest = field.deepest().value();
  const double bound = 2 * (deepest.depth + deepest.error + walls.report.facet) + 64 * ulp();
  for (const ThicknessSample& s : walls.samples) ASSERT_LE(s.thickness, bound);
}

class RandomWalls : public testing::TestWithParam<int> {
 protected:
  Random random{static_cast<std::uint64_t>(GetParam())};
  const Mesh mesh = random_solid(random);
  const Field field = Field::build(mesh.view()).value();
};
INSTANTIATE_TEST_SUITE_P(Solids, RandomWalls, testing::Range(0, 25));

TEST_P(RandomWalls, BallsAgreeWithBisection) {
  const double largest = length(minus(field.bounds().hi, field.bounds().lo));
  for (const double facet : {1e-6, 0.01, 0.3}) {
    for (const bool outside : {false, true}) {
      ThicknessOptions options;
      options.facet = facet;
      options.at = SampleAt::spacing;
      options.spacing = 0.3;
      options.clearance = outside;
      const Thickness walls = thickness(field, options).value();
      const double way = outside ? -1 : 1;
      const Depth depth = [&](const Vec3& p) { return -way * field.distance(p); };
      for (const ThicknessSample& s : walls.samples) {
        const Range truth = ball_diameter(depth, {s.position, times(way, s.normal), facet, largest, 1e-13});
        ASSERT_EQ(std::isnan(s.thickness), truth.low > largest) << s.thickness << " of " << truth.low;
        if (std::isnan(s.thickness)) continue;
        ASSERT_TRUE(truth.meets(s.thickness, s.thickness + s.error))
            << s.thickness << " + " << s.error << " not in " << truth.low << " to " << truth.high << " facet "
            << facet << " outside " << outside;
      }
    }
  }
}

TEST_P(RandomWalls, RaysEndAtTheFirstTriangle) {
  ThicknessOptions options;
  options.method = ThicknessMethod::ray;
  options.at = SampleAt::spacing;
  options.spacing = 0.3;
  for (const bool outside : {false, true}) {
    options.clearance = outside;
    const Thickness walls = thickness(field, options).value();
    for (const ThicknessSample& s : walls.samples) {
      const Range truth = first_hit(mesh.view(), s.position, times(outside ? -1 : 1, s.normal), s.triangle);
      if (truth.low <= 1e-12) continue;
      if (std::isnan(s.thickness)) {
        ASSERT_GE(truth.high, 1) << "nothing was met, but there is a triangle";
        continue;
      }
      ASSERT_TRUE(truth.meets(s.thickness - s.error - 1e-14, s.thickness + s.error + 1e-14))
          << s.thickness << " not in " << truth.low << " to " << truth.high << " outside " << outside;
    }
  }
}

// More tolerance makes no wall thinner.
TEST_P(RandomWalls, GrowWithTheTolerance) {
  Thickness before;
  for (const double facet : {0.0, 1e-9, 1e-3, 0.03, 0.5, 2.0}) {
    ThicknessOptions options;
    options.facet = facet;
    Thickness walls = thickness(field, options).value();
    for (std::size_t i = 0; i < before.samples.size(); ++i) {
      const ThicknessSample& s = walls.samples[i];
      if (std::isnan(s.thickness)) continue;  // above `largest`
      ASSERT_FALSE(std::isnan(before.samples[i].thickness));
      ASSERT_LE(before.samples[i].thickness, s.thickness + s.error + 1e-13);
    }
    before = std::move(walls);
  }
}

}  // namespace
}  // namespace cdfr::oracle
