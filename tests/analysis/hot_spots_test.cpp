/// Hot spots and necks against closed forms.
#include "cdfr/analysis/hot_spots.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "analysis/shapes.h"
#include "cdfr/parts/part.h"

namespace cdfr::test {
namespace {

constexpr double chord = 0.05;

Field field_of(const Mesh& mesh) { return Field::build(mesh.view()).value(); }

double apart(const Vec3& a, const Vec3& b) { return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z); }

class HotSpotsOf : public testing::TestWithParam<std::size_t> {};

TEST_P(HotSpotsOf, AreTheBallsOfTheShape) {
  const Shape shape = shapes(chord)[GetParam()];
  const double error = 0.2;
  const HotSpots found = hot_spots(field_of(shape.mesh), {.error = error, .prominence = 0.4}).value();
  ASSERT_EQ(found.spots.size(), shape.balls.size()) << shape.name;
  for (std::size_t i = 0; i < found.spots.size(); ++i) {
    const HotSpot& spot = found.spots[i];
    SCOPED_TRACE(shape.name + " " + std::to_string(i));
    EXPECT_NEAR(spot.ball.radius, shape.balls[i].radius, shape.error + spot.ball.error);
    EXPECT_LE(spot.ball.error, error);
    EXPECT_GE(shape.depth(spot.ball.centre), shape.balls[i].radius - 2 * shape.error - spot.ball.error);
    EXPECT_FALSE(spot.ball.touches.empty());
    EXPECT_FALSE(spot.fed);
  }
  std::size_t necks = 0;
  for (const HotSpot& spot : found.spots) {
    if (spot.towards == HotSpot::none) continue;
    ASSERT_LT(necks, shape.necks.size()) << shape.name;
    EXPECT_NEAR(spot.neck.radius, shape.necks[necks].radius, shape.error + spot.neck.error) << shape.name;
    EXPECT_DOUBLE_EQ(spot.prominence, spot.ball.radius - spot.neck.radius);
    ++necks;
  }
  EXPECT_EQ(necks, shape.necks.size()) << shape.name;
}

std::string shape_name(const testing::TestParamInfo<std::size_t>& info) {
  std::string name = shapes(chord)[info.param].name;
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Shapes, HotSpotsOf, testing::Range(std::size_t{0}, shapes(chord).size()),
                         shape_name);

TEST(HotSpots, TheNeckOfADumbbellLiesWhereItIsNarrowest) {
  const Shape shape = dumbbell(chord);
  const HotSpots found = hot_spots(field_of(shape.mesh), {.error = 0.1, .prominence = 0.3}).value();
  ASSERT_EQ(found.spots.size(), 2U);
  EXPECT_EQ(found.spots[0].towards, HotSpot::none);
  EXPECT_EQ(found.spots[1].towards, 0U);
  EXPECT_LT(apart(found.spots[1].neck.centre, shape.necks[0].centre), 0.5);
}

TEST(HotSpots, AWallOfEvenThicknessIsNotIsolated) {
  const HotSpots found = hot_spots(field_of(plate(chord).mesh), {.error = 0.1}).value();
  ASSERT_EQ(found.spots.size(), 1U);
  EXPECT_NEAR(found.spots[0].isolation, 1, 0.1);
}

TEST(HotSpots, NoWallLeadsAwayFromABall) {
  const HotSpots found = hot_spots(field_of(ball(chord).mesh), {.error = 0.1}).value();
  ASSERT_EQ(found.spots.size(), 1U);
  EXPECT_EQ(found.spots[0].wall, 0);
  EXPECT_TRUE(std::isinf(found.spots[0].isolation));
}

TEST(HotSpots, TheWallIsTheDeepestPlaceTwiceAsFarAway) {
  const Shape shape = t_junction(0.1);
  const Field field = field_of(shape.mesh);
  const HotSpots found = hot_spots(field, {.error = 0.1}).value();
  ASSERT_EQ(found.spots.size(), 1U);
  const HotSpot& spot = found.spots[0];
  double deepest = 0;
  constexpr int rings = 100;
  for (int i = 0; i <= rings; ++i) {
    for (int k = 0; k < 2 * rings; ++k) {
      const double polar = std::numbers::pi * i / rings, turn = std::numbers::pi * k / rings;
      const double radius = 2 * spot.ball.radius;
      deepest =
          std::max(deepest, -field.distance({spot.ball.centre.x + radius * std::sin(polar) * std::cos(turn),
                                             spot.ball.centre.y + radius * std::sin(polar) * std::sin(turn),
                                             spot.ball.centre.z + radius * std::cos(polar)}));
    }
  }
  EXPECT_GE(spot.wall, deepest - found.error);
  EXPECT_LE(spot.wall, deepest + 2 * spot.ball.radius * std::numbers::pi / rings);
  EXPECT_DOUBLE_EQ(spot.isolation, spot.ball.radius / spot.wall);
}

/// Patch 1: triangles whose corners all have z above the height.
Mesh with_feeder_above(Mesh mesh, double z) {
  mesh.patches.assign(mesh.triangles.size(), 0);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto above = [&](std::uint32_t v) { return mesh.vertices[v].z > z; };
    if (std::all_of(mesh.triangles[i].begin(), mesh.triangles[i].end(), above)) mesh.patches[i] = 1;
  }
  return mesh;
}

TEST(HotSpots, AreFedThroughTheNarrowestBallOnTheWay) {
  const Shape shape = dumbbell(chord);
  const double neck_z = shape.necks[0].centre.z;
  HotSpotOptions options{.error = 0.1, .prominence = 0.3, .feeders = {1}};
  const HotSpots found = hot_spots(field_of(with_feeder_above(shape.mesh, neck_z + 1)), options).value();
  ASSERT_EQ(found.spots.size(), 2U);
  for (const HotSpot& spot : found.spots) {
    ASSERT_TRUE(spot.fed);
    // A ball that touches the feeder needs no way to it.
    const double expected = spot.ball.centre.z > neck_z ? spot.ball.radius : shape.necks[0].radius;
    EXPECT_NEAR(spot.feed.radius, expected, shape.error + spot.feed.error);
  }
  options.feeders = {7};
  EXPECT_EQ(hot_spots(field_of(shape.mesh), options).error().code, Code::bad_option);
}

TEST(HotSpots, TakeCellsByTheMiddlesOfWallsAndNotByTheSurface) {
  const HotSpots found = hot_spots(field_of(cube(chord).mesh), {.error = 0.01}).value();
  ASSERT_EQ(found.spots.size(), 1U);
  EXPECT_LT(found.critical_cells, 1000U);
  EXPECT_NEAR(found.spots[0].ball.radius, 2, found.spots[0].ball.error + 1e-12);
}

TEST(HotSpots, AFeederAllAroundTakesNoMoreCellsThanNone) {
  const Field field = field_of(plate(chord).mesh);
  const HotSpots dry = hot_spots(field, {.error = 0.05}).value();
  const HotSpots fed = hot_spots(field, {.error = 0.05, .feeders = {0, 1, 2}}).value();
  EXPECT_EQ(fed.critical_cells, dry.critical_cells);
  ASSERT_EQ(fed.spots.size(), 1U);
  EXPECT_TRUE(fed.spots[0].fed);
  EXPECT_NEAR(fed.spots[0].feed.radius, fed.spots[0].ball.radius, fed.error);
}

TEST(HotSpots, TheMadeCylinderHeadHasItsHeavyPlace) {
  const Mesh head = make_part("cylinder-head").value();
  const HotSpots found = hot_spots(field_of(head), {.error = 4}).value();
  ASSERT_FALSE(found.spots.empty());
  const HotSpot& heaviest = found.spots[0];
  EXPECT_NEAR(heaviest.ball.radius, 9.5, heaviest.ball.error + 1e-9);
  EXPECT_NEAR(heaviest.ball.centre.x, 240, 0.2);
}

TEST(HotSpots, SameForAnyThreads) {
  const Field field = field_of(t_junction(0.1).mesh);
  const HotSpotOptions options{.error = 0.1};
  const HotSpots one = hot_spots(field, options, {.threads = 1}).value();
  const HotSpots two = hot_spots(field, options, {.threads = 2}).value();
  ASSERT_EQ(one.spots.size(), two.spots.size());
  EXPECT_EQ(one.critical_cells, two.critical_cells);
  for (std::size_t i = 0; i < one.spots.size(); ++i) {
    EXPECT_EQ(one.spots[i].ball.centre, two.spots[i].ball.centre);
    EXPECT_EQ(one.spots[i].ball.touches, two.spots[i].ball.touches);
    EXPECT_EQ(one.spots[i].wall, two.spots[i].wall);
  }
}

TEST(HotSpots, RefuseWhatTheyCannotAnswer) {
  const Mesh cube = make_part("cube").value();
  const Field field = field_of(cube);
  EXPECT_EQ(hot_spots(field, {.error = -1}).error().code, Code::bad_option);
  EXPECT_EQ(hot_spots(field, {.error = std::nan("")}).error().code, Code::bad_option);
  EXPECT_EQ(hot_spots(field, {.error = 1e-300}).error().code, Code::bad_option);
  EXPECT_EQ(hot_spots(field, {.error = 0.1, .prominence = 0.1}).error().code, Code::bad_option);
  const Field unsigned_field = Field::build(cube.view(), {.sign = Sign::none}).value();
  EXPECT_EQ(hot_spots(unsigned_field).error().code, Code::not_closed);
  Mesh open = cube;
  open.triangles.pop_back();
  EXPECT_EQ(hot_spots(field_of(open)).error().code, Code::not_closed);
  const auto stop = [](void*, double) noexcept { return false; };
  EXPECT_EQ(hot_spots(field, {}, {.tick = stop}).error().code, Code::cancelled);
}

}  // namespace
}  // namespace cdfr::test
