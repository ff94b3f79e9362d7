#include "octree/entry_bound.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "octree/scan_scene.h"

namespace cdfr {
namespace {

using test::edge;
using test::Scene;

/// The bound at p as its head comment states it, in edges, squared.
long double stated(const Scene& scene, const Entry& entry, const Vec3& p) {
  const EntryBound& bound = entry.bound();
  const Vec3 a = test::in_edges(p), c = test::in_edges(scene.centre);
  const long double x[3] = {static_cast<long double>(a.x) - c.x, static_cast<long double>(a.y) - c.y,
                            static_cast<long double>(a.z) - c.z};
  const long double distance = entry.distance(), size = scene.size;
  long double value = distance * distance - bound.below * size * size / 128;
  for (int axis = 0; axis < 3; ++axis) {
    value += x[axis] * x[axis] + (distance + 2 * size) * 2 / 127 * bound.slope[axis] * x[axis];
  }
  return value;
}

long double least_squared(const Scene& scene, const Entry& entry, const Vec3& p) {
  long double least = HUGE_VALL;
  for (std::uint32_t lane = 0; lane < group_size; ++lane) {
    if ((entry.lanes() >> lane & 1U) == 0) continue;
    const DoubleDouble d = scene.squared(p, entry.number() * std::uint32_t{group_size} + lane);
    least = std::min(least, (static_cast<long double>(d.hi) + d.lo) / (edge * edge));
  }
  return least;
}

Scene scene_of(test::Random& random, test::Shapes shapes, double size, double away) {
  Scene scene;
  scene.size = size;
  scene.centre = test::anywhere(random, 3);
  const Vec3 to = test::anywhere(random, 3);
  const double extent = edge * std::ldexp(1.0, -static_cast<int>(random.below(12)));
  scene.add(test::shaped_group(random, shapes, test::along(scene.centre, to, away), extent),
            static_cast<std::uint8_t>(1 + random.below(255)));
  return scene;
}

TEST(EntryBound, IsNowhereAboveTheDistanceInTheLeaf) {
  test::Random random(1);
  int bounded = 0;
  for (int i = 0; i < 20000; ++i) {
    const double size = std::ldexp(1.0, -static_cast<int>(random.below(8)));
    const Scene scene = scene_of(random, test::all_shapes[random.below(6)], size, random.between(0, 1));
    const Entry& entry = scene.list[0];
    if (entry.bound().below == EntryBound::none) continue;
    ++bounded;
    for (int k = 0; k < 10; ++k) {
      const Vec3 p =
          k < 8 ? scene.corner(static_cast<std::size_t>(k)) : random.in({scene.corner(0), scene.corner(7)});
      ASSERT_LE(stated(scene, entry, p), least_squared(scene, entry, p));
    }
  }
  EXPECT_GT(bounded, 15000);
}

/// A set that is one point has an affine f: what is lost is rounding of the slope, at most half a step an
/// axis, and of `below`, at most one unit, each twice.
TEST(EntryBound, IsTightForAPoint) {
  test::Random random(2);
  for (int i = 0; i < 2000; ++i) {
    const double size = 0.25;
    const Scene scene = scene_of(random, test::Shapes::one_point, size, 0.5);
    Entry one = scene.list[0];
    Scene single = scene;
    single.list.clear();
    single.add(scene.groups[0], 1);
    one = single.list[0];
    const Vec3 p = random.in({scene.corner(0), scene.corner(7)});
    const double lost = size * (double{one.distance()} + 2 * size) * EntryBound::step * 1.5 +
                        size * size / 64 + double{one.distance()} * one.distance() * 0x1p-14;
    ASSERT_GE(stated(single, one, p), least_squared(single, one, p) - lost);
  }
}

/// Corners that are farther away than numbers of 8 bits can say give no bound rather than a wrong one.
TEST(EntryBound, IsNoneWhereItWouldSayNothing) {
  std::array<double, 8> squared;
  squared.fill(0);
  EXPECT_EQ(entry_bound(squared, 4, 1).below, EntryBound::none);
  squared.fill(1e8);
  EXPECT_EQ(entry_bound(squared, 1e4, 0x1p-10).below, EntryBound::none);
}

}  // namespace
}  // namespace cdfr
