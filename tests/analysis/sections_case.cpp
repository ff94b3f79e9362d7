#include "analysis/sections_case.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/random.h"

namespace cdfr::test {
namespace {

bool holds(const Box& box, const Vec3& p, double slack) {
  return p.x >= box.lo.x - slack && p.y >= box.lo.y - slack && p.z >= box.lo.z - slack &&
         p.x <= box.hi.x + slack && p.y <= box.hi.y + slack && p.z <= box.hi.z + slack;
}

/// No sample of the box is deeper than the ball and its error, if there is only one section that it may be
/// in.
void expect_no_deeper(const Field& field, const Sections& all, const Section& section) {
  Random random(7);
  for (int i = 0; i < 500; ++i) {
    const Vec3 x = random.in(section.box);
    const double depth = -field.distance(x);
    if (depth <= section.ball.radius + section.ball.error) continue;
    const bool elsewhere = std::any_of(all.sections.begin(), all.sections.end(), [&](const Section& other) {
      return &other != &section && holds(other.box, x, 0);
    });
    EXPECT_TRUE(elsewhere) << "deeper at " << x.x << " " << x.y << " " << x.z;
  }
}

void expect_possible(const Field& field, const Sections& all, const Section& section) {
  EXPECT_EQ(-field.distance(section.ball.centre), section.ball.radius);
  EXPECT_GT(section.ball.radius, all.depth);
  EXPECT_LE(section.ball.error, all.error);
  EXPECT_TRUE(holds(section.box, section.ball.centre, 0));
  EXPECT_GE(section.volume_error, 0);
  EXPECT_LE(section.volume - section.volume_error, section.volume);
  EXPECT_GT(section.volume + section.volume_error, 0);
  EXPECT_GT(section.cells, 0U);
  ASSERT_FALSE(section.triangles.empty());
  ASSERT_FALSE(section.ball.touches.empty());
  for (const auto* numbers : {&section.triangles, &section.ball.touches}) {
    EXPECT_TRUE(std::is_sorted(numbers->begin(), numbers->end()));
    EXPECT_EQ(std::adjacent_find(numbers->begin(), numbers->end()), numbers->end());
  }
  const std::uint32_t own = field.closest(section.ball.centre).triangle;
  EXPECT_TRUE(std::binary_search(section.ball.touches.begin(), section.ball.touches.end(), own));
}

}  // namespace

Field field_of(const Mesh& mesh, const BuildOptions& options) {
  return Field::build(mesh.view(), options).value();
}

Sections checked_sections(const Field& field, double depth, const SectionsOptions& options) {
  const Sections all = heavy_sections(field, depth, options).value();
  EXPECT_EQ(all.depth, depth);
  for (const Section& section : all.sections) {
    expect_possible(field, all, section);
    expect_no_deeper(field, all, section);
  }
  EXPECT_TRUE(
      std::is_sorted(all.sections.begin(), all.sections.end(),
                     [](const Section& a, const Section& b) { return a.ball.radius > b.ball.radius; }));
  return all;
}

}  // namespace cdfr::test
