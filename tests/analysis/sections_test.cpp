// Heavy sections against closed forms.
#include "cdfr/analysis/sections.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "analysis/sections_case.h"
#include "analysis/shapes.h"
#include "cdfr/parts/part.h"
#include "support/joined.h"
#include "support/meshes.h"

namespace cdfr {
namespace {

using test::checked_sections;
using test::field_of;

void expect_volume(const Section& section, double volume) {
  EXPECT_LE(std::fabs(section.volume - volume), section.volume_error)
      << section.volume << " +- " << section.volume_error << ", not " << volume;
}

TEST(Sections, OfABoxAreItsInside) {
  const Box box{{0.1, 0.2, 0.3}, {3.1, 4.2, 5.3}};
  const Field field = field_of(test::box_mesh(box));
  for (const double depth : {0.1, 0.75, 1.4}) {
    const Sections found = checked_sections(field, depth, {0.01});
    ASSERT_EQ(found.sections.size(), 1U);
    const Section& section = found.sections[0];
    const double a = 3 - 2 * depth, b = 4 - 2 * depth, c = 5 - 2 * depth;
    expect_volume(section, a * b * c);
    EXPECT_LE(section.volume_error, 0.03 * (a * b + b * c + c * a));
    EXPECT_NEAR(section.area, 2 * (a * b + b * c + c * a), section.area_error);
    EXPECT_NEAR(section.ball.radius, 1.5, section.ball.error);
    EXPECT_NEAR(section.box.lo.x, 0.1 + depth, 0.02);
    EXPECT_NEAR(section.box.hi.z, 5.3 - depth, 0.02);
    EXPECT_TRUE(found.may_join.empty());
  }
}

TEST(Sections, OfATessellatedBall) {
  const Field field = field_of(test::sphere_mesh(4, 3));
  for (const double depth : {0.3, 1.5, 2.7}) {
    const Sections found = checked_sections(field, depth, {0.02});
    ASSERT_EQ(found.sections.size(), 1U) << depth;
    const double r = 3 - depth;
    // The facets' chords are within 0.015 of the sphere.
    const double volume = 4.0 / 3 * std::numbers::pi * r * r * r;
    EXPECT_NEAR(found.sections[0].volume, volume,
                found.sections[0].volume_error + 0.015 * 4 * std::numbers::pi * r * r);
    EXPECT_NEAR(found.sections[0].ball.radius, 3, 0.015 + found.sections[0].ball.error);
  }
}

TEST(Sections, TheComparisonIsStrict) {
  for (const double z : {0.0, 0.1, 1e3}) {
    for (const double thickness : {0.3, 0.125}) {
      const Field field = field_of(test::box_mesh({{0, 0, z}, {3, 2, z + thickness}}));
      const double half = ((z + thickness) - z) / 2;
      const Sections at = heavy_sections(field, half, {0.02}).value();
      EXPECT_TRUE(at.sections.empty());
      EXPECT_TRUE(at.undecided.empty());
      EXPECT_EQ(checked_sections(field, half - 0.01, {0.02}).sections.size(), 1U);
    }
  }
  EXPECT_TRUE(heavy_sections(field_of(test::sphere_mesh(4)), 1).value().sections.empty());
}

TEST(Sections, ASheetFarThinnerThanTheErrorMayBreakUpButIsTold) {
  const Field field = field_of(test::box_mesh({{0, 0, 0.1}, {1, 1, 0.4}}));
  const Sections found = heavy_sections(field, 0.15 - 1e-4, {0.02}).value();
  ASSERT_FALSE(found.sections.empty());
  EXPECT_NEAR(found.sections[0].ball.radius, 0.15, found.sections[0].ball.error + 1e-12);
  EXPECT_GE(found.may_join.size() + 1, found.sections.size());
}

TEST(Sections, OfTwoBodiesAreTwo) {
  const Mesh mesh = test::joined(test::joined(test::sphere_mesh(3, 1), test::sphere_mesh(3, 1.5, {4, 0, 0})),
                                 test::box_mesh({{-6, -1, -1}, {-4, 1, -0.5}}));
  const Sections found = checked_sections(field_of(mesh), 0.5, {0.02});
  ASSERT_EQ(found.sections.size(), 2U);
  EXPECT_NEAR(found.sections[0].ball.centre.x, 4, 0.1);
  EXPECT_NEAR(found.sections[1].ball.centre.x, 0, 0.1);
}

TEST(Sections, EndAtACavity) {
  Mesh hole = test::sphere_mesh(4, 1);
  for (Triangle& t : hole.triangles) std::swap(t[1], t[2]);
  const Sections found = checked_sections(field_of(test::joined(test::sphere_mesh(4, 3), hole)), 0.5, {0.05});
  ASSERT_EQ(found.sections.size(), 1U);
  const double r1 = 2.5, r0 = 1.5, volume = 4.0 / 3 * std::numbers::pi * (r1 * r1 * r1 - r0 * r0 * r0);
  EXPECT_NEAR(found.sections[0].volume, volume, found.sections[0].volume_error + 0.02 * volume);
  EXPECT_NEAR(found.sections[0].ball.radius, 1, 0.02);
}

TEST(Sections, OfShapesWithClosedForms) {
  for (const test::Shape& shape : test::shapes(0.02)) {
    SCOPED_TRACE(shape.name);
    const Field field = field_of(shape.mesh);
    for (const test::DeepLevel& level : shape.levels) {
      SCOPED_TRACE(level.depth);
      const Sections found = checked_sections(field, level.depth, {0.04});
      ASSERT_EQ(found.sections.size(), level.regions.size());
      for (std::size_t i = 0; i < level.regions.size(); ++i) {
        const Section& section = found.sections[i];
        EXPECT_GE(section.volume + section.volume_error, level.regions[i].low);
        EXPECT_LE(section.volume - section.volume_error, level.regions[i].high);
      }
    }
  }
}

TEST(Sections, NecksJoinOrPart) {
  const test::Shape shape = test::dumbbell(0.01);
  const Field field = field_of(shape.mesh);
  ASSERT_EQ(shape.necks.size(), 1U);
  const double neck = shape.necks[0].radius;
  for (const double error : {0.2, 0.05}) {
    for (const double by : {0.15, 0.05, 0.03}) {
      SCOPED_TRACE(by);
      EXPECT_EQ(checked_sections(field, neck + by, {error}).sections.size(), 2U) << error;
      EXPECT_EQ(checked_sections(field, neck - by, {error}).sections.size(), 1U) << error;
    }
  }
}

TEST(Sections, TheHeavySectionOfTheMadeCylinderHeadIsFound) {
  const Field field = field_of(make_part("cylinder-head").value());
  const Sections found = checked_sections(field, 8.5);
  ASSERT_EQ(found.sections.size(), 1U);
  const InscribedBall& ball = found.sections[0].ball;
  EXPECT_NEAR(ball.radius, 9.5, ball.error);
  EXPECT_NEAR(ball.centre.x, 240, 1);
  EXPECT_GT(ball.centre.y, 220);
  EXPECT_LT(ball.centre.y, 240);
  EXPECT_GT(ball.centre.z, 40);
  EXPECT_LT(ball.centre.z, 58);
}

}  // namespace
}  // namespace cdfr
