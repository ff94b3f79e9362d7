/// The ramp keeps its order for everyone who looks at it.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <set>

#include "cdfr/export/painted.h"
#include "export/linear_light.h"

namespace cdfr {
namespace {

using Light = std::array<double, 3>;

double light_of(std::uint8_t level) {
  const double value = level / 255.0;
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

Light seen_by_all(const Light& light) { return light; }

// Who lacks the red or the green receptors sees these: Vienot, Brettel and Mollon, "Digital video colourmaps
// for checking the legibility of displays by dichromats", 1999; for the primaries of sRGB.
Light seen_without_red(const Light& l) {
  const double both = 0.11238 * l[0] + 0.88762 * l[1];
  return {both, both, 0.00401 * l[0] - 0.00401 * l[1] + l[2]};
}
Light seen_without_green(const Light& l) {
  const double both = 0.29275 * l[0] + 0.70725 * l[1];
  return {both, both, -0.02234 * l[0] + 0.02234 * l[1] + l[2]};
}

/// CIE L*, 0 to 100.
double lightness(const Light& l) {
  const double y = 0.2126 * l[0] + 0.7152 * l[1] + 0.0722 * l[2];
  return y > 216.0 / 24389 ? 116 * std::cbrt(y) - 16 : 24389.0 / 27 * y;
}

TEST(ColourRamp, DarkensEvenlyForEveryEye) {
  constexpr int steps = 40;
  for (const auto seen : {&seen_by_all, &seen_without_red, &seen_without_green}) {
    double before = 0;
    for (int i = 0; i <= steps; ++i) {
      const Colour colour = painted_colour(i, 0, steps);
      const double now = lightness(seen({light_of(colour[0]), light_of(colour[1]), light_of(colour[2])}));
      if (i > 0) {
        EXPECT_LT(now, before - 0.8) << i;
        EXPECT_GT(now, before - 4) << i;
      }
      before = now;
    }
  }
}

TEST(ColourRamp, IsWarmWhereItIsThinAndColdWhereItIsThick) {
  const Colour thin = painted_colour(0, 0, 1), thick = painted_colour(1, 0, 1);
  EXPECT_GT(thin[0], thin[2] + 100);
  EXPECT_GT(thick[2], thick[0] + 50);
}

TEST(ColourRamp, HasAColourForEveryNumber) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr double most = std::numeric_limits<double>::max(),
                   tiny = std::numeric_limits<double>::denorm_min();
  const Colour thin = painted_colour(0, 0, 1), thick = painted_colour(1, 0, 1),
               middle = painted_colour(0.5, 0, 1);
  EXPECT_EQ(painted_colour(-infinity, 0, 1), thin);
  EXPECT_EQ(painted_colour(infinity, 0, 1), thick);
  EXPECT_EQ(painted_colour(0, -most, most), middle);
  EXPECT_EQ(painted_colour(tiny, 0, 2 * tiny), middle);
  EXPECT_EQ(painted_colour(3, 3, 3), middle);
  EXPECT_EQ(painted_colour(2.9, 3, 3), thin);
  EXPECT_EQ(painted_colour(3.1, 3, 3), thick);
  const Colour none = painted_colour(std::numeric_limits<double>::quiet_NaN(), 0, 1);
  EXPECT_EQ(std::set<int>(none.begin(), none.end()).size(), 1U) << "grey";
}

TEST(ColourRamp, LightIsThatOfTheStandard) {
  const auto light = linear_light();
  for (std::size_t level = 0; level < light.size(); ++level)
    EXPECT_FLOAT_EQ(light[level], static_cast<float>(light_of(static_cast<std::uint8_t>(level)))) << level;
}

}  // namespace
}  // namespace cdfr
