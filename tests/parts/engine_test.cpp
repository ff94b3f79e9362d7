#include <gtest/gtest.h>

#include <cstddef>

#include "cdfr/parts/part.h"
#include "oracle/point_count.h"
#include "parts/depth_probe.h"

namespace cdfr {
namespace {

using test::DepthProbe;

const DepthProbe& probe() {
  static const Mesh engine = make_part("engine").value();
  static const DepthProbe made(engine, 4);
  return made;
}

TEST(Engine, EveryVerticalLineEntersAndLeavesInTurn) { probe().expect_alternating(20000); }

TEST(Engine, TheHeavySectionIsElevenDeep) {
  const Vec3 centre{300, 150, 172.5};
  EXPECT_TRUE(probe().inside({300, 150.01, 172.5}));
  EXPECT_EQ(probe().distance(centre), 11);
  EXPECT_EQ(probe().distance({300, 145, 161}), 11);
  EXPECT_EQ(probe().distance({300, 155, 184}), 11);
}

TEST(Engine, NothingElseIsDeeperThanSix) {
  // The search is the test's own code, and long.
  if (oracle::light_run()) GTEST_SKIP() << "left to runs without sanitizers";
  std::size_t found = 0;
  for (const DepthProbe::Place& place : probe().deeper_than(6, 0.5)) {
    const Vec3 p = place.point;
    ASSERT_TRUE(p.x > 289 && p.x < 311 && p.y > 134 && p.y < 166 && p.z > 150 && p.z < 195)
        << p.x << " " << p.y << " " << p.z << ": " << place.depth;
    ++found;
  }
  EXPECT_GT(found, 0U);
}

}  // namespace
}  // namespace cdfr
