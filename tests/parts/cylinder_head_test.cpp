#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <set>
#include <tuple>
#include <vector>

#include "cdfr/parts/part.h"
#include "oracle/point_count.h"
#include "parts/depth_probe.h"
#include "parts/mesh_check.h"

namespace cdfr {
namespace {

using test::DepthProbe;

const Mesh& head() {
  static const Mesh mesh = make_part("cylinder-head").value();
  return mesh;
}

const DepthProbe& probe() {
  static const DepthProbe made(head(), 4);
  return made;
}

/// The heavy block, see add_heavy_section.
constexpr Box block{{230.5, 217, 31}, {249.5, 243, 67}};

bool in_block(Vec3 p) {
  return p.x > block.lo.x && p.x < block.hi.x && p.y > block.lo.y && p.y < block.hi.y && p.z > block.lo.z &&
         p.z < block.hi.z;
}

TEST(CylinderHead, MeasuresWhatThePaperSays) {
  const test::MeshCheck check = test::check_mesh(head());
  EXPECT_EQ(check.box, (Box{{0, 0, 0}, {480, 266, 157}}));
  EXPECT_GE(head().triangles.size(), 130000U);
  EXPECT_LE(head().triangles.size(), 140000U);
  const double kilograms = check.volume * 7.2e-6;
  EXPECT_NEAR(kilograms, 40, 4);
}

TEST(CylinderHead, EveryVerticalLineEntersAndLeavesInTurn) { probe().expect_alternating(20000); }

TEST(CylinderHead, NothingElseIsDeeperThanSevenPointFour) {
  // The search is the test's own code, and long.
  if (oracle::light_run()) GTEST_SKIP() << "left to runs without sanitizers";
  std::size_t found = 0;
  for (const DepthProbe::Place& place : probe().deeper_than(7.4, 0.2)) {
    ASSERT_TRUE(in_block(place.point))
        << place.point.x << " " << place.point.y << " " << place.point.z << ": " << place.depth;
    ++found;
  }
  EXPECT_GT(found, 0U);
}

TEST(CylinderHead, TheHeavySectionIsNineAndAHalfDeep) {
  const Vec3 centre{240, 230, 49};
  EXPECT_TRUE(probe().inside(centre));
  EXPECT_EQ(probe().distance(centre), 9.5);
  EXPECT_EQ(probe().distance({240, 226.5, 40.5}), 9.5);
  EXPECT_EQ(probe().distance({240, 233.5, 57.5}), 9.5);
  EXPECT_TRUE(probe().deeper_than(9.6, 0.1).empty());
}

/// Samples every half millimetre; neighbours along the axes are joined.
TEST(CylinderHead, TheHeavySectionIsOneRegionAtEightAndAHalf) {
  using Sample = std::tuple<int, int, int>;
  std::set<Sample> deep;
  for (int x = 0; x < 38; ++x) {
    for (int y = 0; y < 52; ++y) {
      for (int z = 0; z < 72; ++z) {
        const Vec3 p{block.lo.x + 0.25 + x / 2.0, block.lo.y + 0.25 + y / 2.0, block.lo.z + 0.25 + z / 2.0};
        if (probe().distance(p) > 8.5) deep.insert({x, y, z});
      }
    }
  }
  ASSERT_FALSE(deep.empty());
  std::vector<Sample> stack{*deep.begin()};
  deep.erase(deep.begin());
  while (!stack.empty()) {
    const auto [x, y, z] = stack.back();
    stack.pop_back();
    for (const Sample& next : {Sample{x - 1, y, z}, Sample{x + 1, y, z}, Sample{x, y - 1, z},
                               Sample{x, y + 1, z}, Sample{x, y, z - 1}, Sample{x, y, z + 1}}) {
      if (deep.erase(next) == 1) stack.push_back(next);
    }
  }
  EXPECT_TRUE(deep.empty());
}

}  // namespace
}  // namespace cdfr
