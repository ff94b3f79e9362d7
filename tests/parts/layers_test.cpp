#include "parts/layers.h"

#include <gtest/gtest.h>

#include <vector>

#include "parts/mesh_check.h"

namespace cdfr {
namespace {

using test::check_mesh;
using test::MeshCheck;

void expect_solid(const MeshCheck& check) {
  EXPECT_EQ(check.lone_edges, 0U);
  EXPECT_EQ(check.repeated_edges, 0U);
  EXPECT_EQ(check.pinched, 0U);
}

TEST(Layers, BlockHasItsVolume) {
  const std::vector<Step> steps{{rectangle(0, 0, 20, 10), 0, 5, true}};
  const Mesh mesh = build_layers(steps, {.spacing = 3, .layer = 2, .size = {20, 10, 5}});
  const MeshCheck check = check_mesh(mesh);
  expect_solid(check);
  EXPECT_NEAR(check.volume, 1000, 1e-9);
  EXPECT_EQ(check.box, (Box{{0, 0, 0}, {20, 10, 5}}));
}

TEST(Layers, LaterStepsWin) {
  const std::vector<Step> steps{{rectangle(0, 0, 20, 20), 0, 10, true},
                                {rectangle(5, 5, 15, 15), 2, 8, false},   // a closed hollow
                                {rectangle(8, 8, 12, 12), 0, 10, true}};  // a post through it
  const MeshCheck check = check_mesh(build_layers(steps, {.spacing = 3, .layer = 2, .size = {20, 20, 10}}));
  expect_solid(check);
  EXPECT_EQ(check.components, 2U);
  EXPECT_NEAR(check.volume, 4000 - 6 * (100 - 16), 1e-9);
}

double slope(double x, double, double z) noexcept { return z * (1 + x / 16); }

TEST(Layers, LiftMovesHeightsOnly) {
  const std::vector<Step> steps{{rectangle(0, 0, 16, 8), 0, 4, true}};
  const MeshCheck check =
      check_mesh(build_layers(steps, {.spacing = 3, .layer = 2, .size = {16, 8, 4}, .lift = slope}));
  expect_solid(check);
  EXPECT_NEAR(check.volume, 16 * 8 * 4 * 1.5, 1e-9);
  EXPECT_EQ(check.box.hi.z, 8);
}

}  // namespace
}  // namespace cdfr
