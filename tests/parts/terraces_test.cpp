#include "parts/terraces.h"

#include <gtest/gtest.h>

#include <cstddef>

#include "parts/mesh_check.h"

namespace cdfr {
namespace {

using test::check_mesh;
using test::MeshCheck;

/// Walls count by their sides, holes once, and each surface takes one away.
void expect_solid(const Recipe& recipe, std::size_t sides, std::size_t holes, std::size_t surfaces,
                  double volume) {
  const Mesh mesh = build_terraces(recipe.steps, 1);
  const MeshCheck check = check_mesh(mesh);
  EXPECT_EQ(check.lone_edges, 0U);
  EXPECT_EQ(check.repeated_edges, 0U);
  EXPECT_EQ(check.pinched, 0U);
  EXPECT_EQ(check.unused, 0U);
  EXPECT_EQ(check.twins, 0U);
  EXPECT_GT(check.smallest_area, 0);
  EXPECT_EQ(check.components, surfaces);
  EXPECT_EQ(mesh.triangles.size(), 4 * (sides + holes - surfaces));
  EXPECT_NEAR(check.volume, volume, 1e-12 * volume);
}

Recipe block() {
  Recipe recipe;
  recipe.fill(rectangle(0, 0, 20, 20), 0, 10);
  return recipe;
}

TEST(Terraces, Block) { expect_solid(block(), 4, 0, 1, 4000); }

TEST(Terraces, CoordinatesAreTheNearestToTheDecimals) {
  Recipe recipe;
  recipe.fill(rectangle(0, 0, 69, 2), 0, 29);
  const MeshCheck check = check_mesh(build_terraces(recipe.steps, 10));
  EXPECT_EQ(check.box, (Box{{0, 0, 0}, {6.9, 0.2, 2.9}}));
}

TEST(Terraces, PocketWithAnIslandAndABossOnIt) {
  Recipe recipe = block();
  recipe.empty(rectangle(2, 2, 18, 18), 4, 10);
  recipe.fill(rectangle(4, 4, 12, 12), 4, 14);
  recipe.fill(rectangle(6, 6, 8, 8), 14, 20);
  expect_solid(recipe, 16, 0, 1, 4000 - 6 * 256 + 10 * 64 + 6 * 4);
}

TEST(Terraces, HolesGoThrough) {
  Recipe recipe = block();
  for (const double x : {4.0, 12.0}) recipe.empty(rectangle(x, 8, x + 4, 12), 0, 10);
  expect_solid(recipe, 12, 2, 1, 4000 - 2 * 160);
}

/// A step in the hole, whose wider part is the place around the narrower one.
TEST(Terraces, CounterboreInAHole) {
  Recipe recipe = block();
  recipe.empty(rectangle(8, 8, 12, 12), 0, 10);
  recipe.empty(rectangle(6, 6, 14, 14), 7, 10);
  expect_solid(recipe, 12, 1, 1, 4000 - 7 * 16 - 3 * 64);
}

TEST(Terraces, AShutHollowIsASurfaceOfItsOwn) {
  Recipe recipe = block();
  recipe.empty(rectangle(5, 5, 15, 15), 2, 8);
  expect_solid(recipe, 8, 0, 2, 4000 - 600);
}

/// An outline leaves no trace where both of its sides begin and end together: the body below and above its
/// flange is two walls, and the flange's own faces are rings around them.
TEST(Terraces, BodyWithAFlangeInTheMiddle) {
  Recipe recipe;
  recipe.fill(rectangle(5, 5, 15, 15), 0, 10);
  recipe.fill(rectangle(0, 0, 20, 20), 4, 6);
  expect_solid(recipe, 12, 0, 1, 1000 + 2 * 300);
  recipe.fill(rectangle(0, 0, 20, 20), 0, 10);
  expect_solid(recipe, 4, 0, 1, 4000);
}

TEST(Terraces, EmptiedWithinASmallerOutlineAsWell) {
  Recipe recipe = block();
  recipe.fill(rectangle(8, 8, 12, 12), 10, 15);
  recipe.empty(rectangle(4, 4, 16, 16), 5, 20);
  expect_solid(recipe, 8, 0, 1, 4000 - 5 * 144);
}

}  // namespace
}  // namespace cdfr
