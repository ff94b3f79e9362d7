// No triangle that is closest somewhere in a cube is left out of its list, no support is above a distance,
// and no small cube is passed over: by the exact kernel, for triangles of every shape near and far.
#include "geometry/supports.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numeric>
#include <vector>

#include "geometry/query_range.h"
#include "geometry/scan_cases.h"
#include "support/instruction_sets.h"

namespace cdfr {
namespace {

constexpr double half = 0.25;
constexpr double placing = 0x1p-49;  ///< what a point's own rounding is worth here

/// A cube of half edge `half` in its middle, and triangles of every shape about it, some through it.
struct Scene {
  explicit Scene(std::uint64_t seed) : random(seed), middle(random.in({{-1, -1, -1}, {1, 1, 1}})) {
    const double off = std::ldexp(1.0, 3 - static_cast<int>(random.below(6)));
    for (const test::Shapes kind : test::all_shapes) {
      for (int i = 0; i < 8; ++i) {
        const Vec3 at = random.in({{-off, -off, -off}, {off, off, off}});
        const double size = std::ldexp(1.0, -static_cast<int>(random.below(6)));
        const Vec3 c{middle.x + at.x, middle.y + at.y, middle.z + at.z};
        const std::array<Vec3, 3> corners = test::corners_of(
            random, kind, {{c.x - size, c.y - size, c.z - size}, {c.x + size, c.y + size, c.z + size}});
        shapes.push_back({corners, unit_normal(corners[0], corners[1], corners[2])});
        frames.push_back(triangle_frame(shapes.back(), middle, 4 * half));
        error = std::max(error, frames.back().error);
      }
    }
    numbers.resize(frames.size());
    std::iota(numbers.begin(), numbers.end(), std::uint16_t{0});
  }

  double distance(std::size_t number, const Vec3& from_middle) const {
    const Vec3 p{middle.x + from_middle.x, middle.y + from_middle.y, middle.z + from_middle.z};
    return square_root(measure(p, shapes[number]).squared);
  }
  Vec3 point_about(const Vec3& c, double reach) {
    const Vec3 x = random.in({{-reach, -reach, -reach}, {reach, reach, reach}});
    return {c.x + x.x, c.y + x.y, c.z + x.z};
  }

  test::Random random;
  Vec3 middle;
  std::vector<TriangleShape> shapes;
  std::vector<TriangleFrame> frames;
  std::vector<std::uint16_t> numbers;
  double error = 0;
};

RegionPoints one_point(const Vec3& p) {
  RegionPoints points;
  points.add(p);
  return points;
}

RegionPoints octants() {
  RegionPoints points;
  for (int i = 0; i < 8; ++i)
    points.add({i & 1 ? half / 2 : -half / 2, i & 2 ? half / 2 : -half / 2, i & 4 ? half / 2 : -half / 2});
  return points;
}

/// Of a list, where it may be closest in cube `cube`: the places.
std::vector<std::size_t> near_places(const Supports& supports, std::size_t count, std::size_t cube) {
  std::vector<std::size_t> places;
  for (std::size_t n = 0; n < count; ++n) {
    if ((supports.near[n] >> cube & 1U) != 0) places.push_back(n);
  }
  return places;
}

/// As seen from the whole cube, then from its octants with what that said.
struct TwoLevels {
  explicit TwoLevels(const Scene& scene)
      : whole(std::make_unique<Supports>()), eighths(std::make_unique<Supports>()) {
    find_supports({scene.frames, scene.numbers}, one_point({0, 0, 0}), half, scene.error, *whole);
    for (const std::size_t n : near_places(*whole, scene.numbers.size(), 0)) {
      numbers.push_back(scene.numbers[n]);
      axes.push_back(whole->axis(n, 0, {0, 0, 0}));
    }
    find_supports({scene.frames, numbers, axes, support_slack * scene.error}, octants(), half / 2,
                  scene.error, *eighths);
  }

  std::unique_ptr<Supports> whole, eighths;
  std::vector<std::uint16_t> numbers;
  std::vector<TriangleFrame::Axis> axes;
};

double by_axis(const TriangleFrame::Axis& axis, const Vec3& p) {
  return axis.way[0] * p.x + axis.way[1] * p.y + axis.way[2] * p.z - axis.start;
}

TEST(Supports, KeepWhatIsClosestSomewhere) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    Scene scene(seed);
    const TwoLevels levels(scene);
    for (std::size_t octant = 0; octant < 8; ++octant) {
      const Vec3 centre = octants().point(octant);
      for (int i = 0; i < 20; ++i) {
        const Vec3 p = scene.point_about(centre, half / 2);
        double least = HUGE_VAL, kept = HUGE_VAL;
        for (const std::uint16_t n : scene.numbers) least = std::min(least, scene.distance(n, p));
        for (const std::size_t place : near_places(*levels.eighths, levels.numbers.size(), octant))
          kept = std::min(kept, scene.distance(levels.numbers[place], p));
        ASSERT_EQ(least, kept) << "seed " << seed;
      }
    }
  }
}

TEST(Supports, AreBelowDistances) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    Scene scene(seed);
    const TwoLevels levels(scene);
    for (std::size_t k = 0; k < levels.axes.size(); ++k) {
      for (int i = 0; i < 8; ++i) {
        const Vec3 p = scene.point_about({0, 0, 0}, half);
        ASSERT_LE(by_axis(levels.axes[k], p),
                  scene.distance(levels.numbers[k], p) + support_slack * scene.error + placing)
            << "seed " << seed;
      }
    }
  }
}

/// Of the scene's small cubes in the order of the answer, those whose distance is from lo to hi.
std::vector<Vec3> between(const Scene& scene, const SmallCubes& cubes, double lo, double hi) {
  std::vector<Vec3> found;
  const std::size_t all = cubes.along * cubes.along * cubes.along;
  for (std::size_t i = 0; i < all; ++i) {
    const auto at = [&](std::size_t axis) {
      const auto place = static_cast<double>((i >> axis & 1U) + 2 * (i >> (axis + 3) & 1U));
      return (place - 0.5 * static_cast<double>(cubes.along - 1)) * cubes.size;
    };
    const Vec3 p{at(0), at(1), at(2)};
    double least = HUGE_VAL;
    for (const std::uint16_t n : scene.numbers) least = std::min(least, scene.distance(n, p));
    if (lo <= least && least <= hi) found.push_back(p);
  }
  return found;
}

TEST(Supports, FindAllSmallCubesBetween) {
  int told = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    Scene scene(seed);
    const TwoLevels levels(scene);
    const double closest = levels.whole->least[0];
    if (closest < half) continue;
    ++told;
    for (const std::size_t along : {1, 2, 4}) {
      const SmallCubes cubes{{0, 0, 0}, along, 2 * half / static_cast<double>(along)};
      const double lo = closest + scene.random.between(-half, half), hi = lo + half / 4;
      RegionPoints found;
      const double slack = (support_slack + 1) * scene.error + placing;
      find_between(levels.axes, cubes, closest, lo - slack, hi + slack, found);
      std::size_t next = 0;
      for (const Vec3& p : between(scene, cubes, lo, hi)) {
        while (next < found.count && !(found.point(next) == p)) ++next;
        ASSERT_LT(next, found.count) << "seed " << seed;
      }
    }
  }
  EXPECT_GT(told, 30);
}

TEST(Supports, SpareWorkAndChangeNoBit) {
  test::on_every_instruction_set([] {
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
      Scene scene(seed);
      const TwoLevels levels(scene);
      RegionPoints points;
      while (points.count < Feet::most - 3) points.add(scene.point_about({0, 0, 0}, half));
      const NearTriangles alone{scene.frames, levels.numbers};
      const NearTriangles helped{scene.frames, levels.numbers, levels.axes, support_slack * scene.error};
      Feet feet, same;
      find_feet(alone, points, 0, feet);
      find_feet(helped, points, 0, same);
      alignas(64) double squared[RegionPoints::most], same_squared[RegionPoints::most];
      const double most = levels.whole->least[0];
      squared_distances(alone, points, squared, most);
      squared_distances(helped, points, same_squared, most);
      for (std::size_t i = 0; i < points.count; ++i) {
        ASSERT_EQ(feet.distance[i], same.distance[i]) << "seed " << seed;
        ASSERT_EQ(feet.number[i], same.number[i]) << "seed " << seed;
        ASSERT_EQ(feet.place[i], same.place[i]) << "seed " << seed;
        ASSERT_EQ(squared[i], same_squared[i]) << "seed " << seed;
        if (!(feet.distance[i] > 0)) continue;
        for (int axis = 0; axis < 3; ++axis) ASSERT_EQ(feet.away[axis][i], same.away[axis][i]);
      }
    }
  });
}

TEST(Supports, AreTheSameOnEveryInstructionSet) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Scene scene(seed);
    std::vector<double> first;
    test::on_every_instruction_set([&] {
      const TwoLevels levels(scene);
      std::vector<double> said(levels.eighths->least.begin(), levels.eighths->least.end());
      for (std::size_t octant = 0; octant < 8; ++octant) {
        for (const std::size_t place : near_places(*levels.eighths, levels.numbers.size(), octant)) {
          const TriangleFrame::Axis axis = levels.eighths->axis(place, octant, octants().point(octant));
          said.insert(said.end(), {static_cast<double>(levels.numbers[place]), axis.way[0], axis.way[1],
                                   axis.way[2], axis.start});
        }
      }
      if (first.empty()) first = said;
      ASSERT_EQ(said, first) << "seed " << seed;
    });
  }
}

}  // namespace
}  // namespace cdfr
