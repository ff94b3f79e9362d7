// Heavy sections of shapes whose deep regions are closed forms.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "analysis/shapes.h"
#include "cdfr/analysis/sections.h"
#include "oracle/range.h"

namespace cdfr {
namespace {

constexpr double rounding = 1e-9;

class SectionsOf : public testing::TestWithParam<std::size_t> {
 protected:
  static constexpr double chord = 0.02;

  Sections found(double depth, double error = 0.03) const {
    SectionsOptions options;
    options.error = error;
    return heavy_sections(field, depth, options).value();
  }

  const test::Shape shape = test::shapes(chord)[GetParam()];
  const Field field = Field::build(shape.mesh.view()).value();
};
INSTANTIATE_TEST_SUITE_P(Shapes, SectionsOf, testing::Range(std::size_t{0}, test::shapes(0.05).size()));

/// The mesh's largest ball has the solid's radius but for the shape's error; its centre is in the solid
/// almost as deep, and only there.
void expect_ball(const test::Shape& shape, const InscribedBall& ball, const test::InscribedBall& truth) {
  EXPECT_GE(ball.radius + ball.error, truth.radius - shape.error - rounding);
  EXPECT_LE(ball.radius, truth.radius + shape.error + rounding);
  EXPECT_GE(shape.depth(ball.centre), ball.radius - shape.error - rounding);
  if (truth.only) {
    const Vec3 &a = ball.centre, &b = truth.centre;
    EXPECT_LE(std::hypot(a.x - b.x, a.y - b.y, a.z - b.z), 3 * (2 * shape.error + ball.error) + rounding);
  }
  EXPECT_FALSE(ball.touches.empty());
  EXPECT_TRUE(std::ranges::is_sorted(ball.touches));
}

TEST_P(SectionsOf, AreAsManyAndAsLargeAsInTheSolid) {
  SCOPED_TRACE(shape.name);
  for (const test::DeepLevel& level : shape.levels) {
    SCOPED_TRACE(level.depth);
    const Sections sections = found(level.depth);
    EXPECT_TRUE(sections.may_join.empty());
    ASSERT_EQ(sections.sections.size(), level.regions.size());
    for (std::size_t i = 0; i < level.regions.size(); ++i) {
      const Section& section = sections.sections[i];
      const test::Region& region = level.regions[i];
      EXPECT_TRUE(
          (oracle::Range{region.low, region.high}.meets(section.volume - section.volume_error - rounding,
                                                        section.volume + section.volume_error + rounding)))
          << section.volume << " +- " << section.volume_error << " not in " << region.low << " to "
          << region.high;
      EXPECT_LE(section.volume_error, 2 * sections.error * section.area + sections.error);
      EXPECT_GT(section.ball.radius, level.depth);
      EXPECT_LE(section.ball.error, sections.error + rounding);
      EXPECT_NEAR(-field.distance(section.ball.centre), section.ball.radius, rounding);
      expect_ball(shape, section.ball, shape.balls[i]);
    }
  }
}

TEST_P(SectionsOf, NestWithDepth) {
  SCOPED_TRACE(shape.name);
  const double deepest = shape.balls.front().radius;
  double before = shape.volume * 2;
  for (const double share : {0.2, 0.5, 0.8}) {
    double volume = 0, doubt = 0;
    const Sections sections = found(share * deepest, 0.15);
    for (const Section& section : sections.sections) {
      volume += section.volume;
      doubt += section.volume_error;
      for (const double way :
           {section.ball.centre.x - section.box.lo.x, section.box.hi.x - section.ball.centre.x,
            section.ball.centre.y - section.box.lo.y, section.box.hi.y - section.ball.centre.y,
            section.ball.centre.z - section.box.lo.z, section.box.hi.z - section.ball.centre.z}) {
        EXPECT_GE(way, section.ball.radius - share * deepest - rounding)
            << "the ball less T is in the section";
      }
    }
    EXPECT_LE(volume - doubt, before + rounding) << share;
    before = volume + doubt;
  }
}

// Deeper than T is meant strictly: at the depth of the deepest point there is nothing, and just below it
// there is.
TEST_P(SectionsOf, EndAtTheDeepestPoint) {
  SCOPED_TRACE(shape.name);
  const Deepest deepest = field.deepest(0.01).value();
  EXPECT_TRUE(found(deepest.depth + deepest.error + rounding).sections.empty());
  EXPECT_FALSE(found(0.9 * deepest.depth, 0.1).sections.empty());
}

TEST(SectionsAtEquality, AreNone) {
  const struct {
    test::Shape shape;
    double depth;
  } cases[] = {{test::plate(0), 1}, {test::box(0), 1.5}, {test::cube(0), 2}, {test::stepped_plate(0), 2.5}};
  for (const auto& c : cases) {
    SCOPED_TRACE(c.shape.name);
    const Field field = Field::build(c.shape.mesh.view()).value();
    const Sections at = heavy_sections(field, c.depth, {}).value();
    EXPECT_TRUE(at.sections.empty());
    EXPECT_TRUE(at.may_join.empty());
    const Sections below = heavy_sections(field, c.depth * 0.98, {}).value();
    EXPECT_EQ(below.sections.size(), 1U);
  }
}

TEST(SectionsOfDumbbell, PartWhereTheNeckIs) {
  const double chord = 0.01;
  const test::Shape shape = test::dumbbell(chord);
  const Field field = Field::build(shape.mesh.view()).value();
  const double neck = shape.necks.front().radius;
  SectionsOptions options;
  options.error = 0.02;
  const auto at = [&](double depth) { return heavy_sections(field, depth, options).value(); };
  for (const double off : {0.015, 0.1}) {
    SCOPED_TRACE(off);
    EXPECT_EQ(at(neck - off).sections.size(), 1U);
    EXPECT_EQ(at(neck + off).sections.size(), 2U);
    EXPECT_TRUE(at(neck - off).may_join.empty());
    EXPECT_TRUE(at(neck + off).may_join.empty());
  }
}

}  // namespace
}  // namespace cdfr
