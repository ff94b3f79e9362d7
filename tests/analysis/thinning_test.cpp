// Two revisions compared.
#include <gtest/gtest.h>

#include <cmath>

#include "cdfr/analysis/thickness.h"
#include "support/meshes.h"

namespace cdfr {
namespace {

Thinning between(const Mesh& now, const Mesh& former, ThicknessOptions options,
                 const ThinningOptions& how = {}) {
  const Field field = Field::build(now.view()).value(), old = Field::build(former.view()).value();
  return thinning(field, thickness(field, options).value(), options, old, how).value();
}

ThicknessOptions sampled() {
  ThicknessOptions options;
  options.at = SampleAt::spacing;
  options.spacing = 0.5;
  return options;
}

TEST(Thinning, OfTheSamePartIsNone) {
  for (const Mesh& mesh : {test::box_mesh({{0, 0, 0}, {12, 10, 2}}), test::icosphere(3)}) {
    const Thinning found = between(mesh, mesh, sampled());
    EXPECT_GT(found.compared, 100U);
    EXPECT_EQ(found.area, 0);
    EXPECT_TRUE(found.places.empty());
  }
}

TEST(Thinning, OfAPlateThatLostAnEighth) {
  const Mesh former = test::box_mesh({{0, 0, 0}, {12, 10, 2}}),
             now = test::box_mesh({{0, 0, 0}, {12, 10, 1.75}});
  ThinningOptions how;
  how.reach = 0.5;
  const Thinning found = between(now, former, sampled(), how);
  EXPECT_EQ(found.reach, 0.5);
  ASSERT_FALSE(found.places.empty());
  EXPECT_NEAR(found.places[0].former, 2, 1e-6);
  EXPECT_NEAR(found.places[0].thickness, 1.75, 1e-6);
  EXPECT_GT(found.area, 150);
  how.change = 0.3;
  EXPECT_TRUE(between(now, former, sampled(), how).places.empty()) << "less was lost than asked for";
  EXPECT_TRUE(between(former, now, sampled(), how).places.empty()) << "it grew";
}

/// A former surface farther away, or one that faces elsewhere, is not the same wall.
TEST(Thinning, ComparesTheSameWallsAlone) {
  const Mesh former = test::box_mesh({{0, 0, 0}, {12, 10, 2}}),
             now = test::box_mesh({{0, 0, 0}, {12, 10, 1}});
  ThinningOptions how;
  how.reach = 0.1;
  const Thinning found = between(now, former, sampled(), how);
  EXPECT_GT(found.unmatched, 100U);
  ASSERT_FALSE(found.places.empty());
  for (const ThinnedPlace& place : found.places) EXPECT_LT(place.position.z, 1);
}

TEST(Thinning, RefusesByName) {
  const Field field = Field::build(test::box_mesh({{0, 0, 0}, {3, 4, 5}}).view()).value();
  const Thickness now = thickness(field).value();
  ThinningOptions how;
  how.reach = -1;
  EXPECT_EQ(thinning(field, now, {}, field, how).error().code, Code::bad_option);
  how = {};
  how.change = INFINITY;
  EXPECT_EQ(thinning(field, now, {}, field, how).error().code, Code::bad_option);
  BuildOptions none;
  none.sign = Sign::none;
  const Field flat = Field::build(test::box_mesh({{0, 0, 0}, {3, 4, 5}}).view(), none).value();
  EXPECT_EQ(thinning(field, now, {}, flat).error().code, Code::not_closed);
}

}  // namespace
}  // namespace cdfr
