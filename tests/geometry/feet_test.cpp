#include "geometry/feet.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <numeric>
#include <vector>

#include "geometry/query_range.h"
#include "geometry/scan_cases.h"
#include "support/instruction_sets.h"

namespace cdfr {
namespace {

constexpr double radius = 0.25;

/// Triangles of every shape around a region somewhere, and points of it, some of them on or near features.
struct Scene {
  explicit Scene(std::uint64_t seed) : random(seed), middle(random.in({{-1, -1, -1}, {1, 1, 1}})) {
    for (const test::Shapes kind : test::all_shapes) {
      const double size = std::ldexp(1.0, -static_cast<int>(random.below(8)));
      const Box box{{middle.x - size, middle.y - size, middle.z - size},
                    {middle.x + size, middle.y + size, middle.z + size}};
      for (int i = 0; i < 2; ++i) {
        const std::array<Vec3, 3> c = test::corners_of(random, kind, box);
        this->shapes.push_back({c, unit_normal(c[0], c[1], c[2])});
        frames.push_back(triangle_frame(this->shapes.back(), middle, radius));
      }
    }
    numbers.resize(frames.size());
    std::iota(numbers.begin(), numbers.end(), std::uint16_t{0});
    while (points.count < 3 * Feet::most - 5) points.add(point());
  }

  Vec3 point() {
    const auto near = [&] { return random.between(-radius / 2, radius / 2); };
    const double x = near(), y = near(), z = near();
    if (random.below(3) > 0) return {x, y, z};
    // By a corner of a triangle, if that is in the region.
    const Vec3& v = shapes[random.below(shapes.size())].vertices[random.below(3)];
    const double off = std::ldexp(random.between(-1, 1), -static_cast<int>(random.below(50)));
    const Vec3 p{v.x - middle.x + off, v.y - middle.y, v.z - middle.z};
    return std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)}) < radius / 2 ? p : Vec3{x, y, z};
  }

  double least(const Vec3& p, double& error) const {
    double least = HUGE_VAL;
    for (std::size_t i = 0; i < shapes.size(); ++i) {
      least = std::min(least, square_root(measure(p, shapes[i]).squared));
      error = std::max(error, frames[i].error);
    }
    return least;
  }

  test::Random random;
  Vec3 middle;
  std::vector<TriangleShape> shapes;
  std::vector<TriangleFrame> frames;
  std::vector<std::uint16_t> numbers;
  RegionPoints points;
};

/// Of the point from the middle; its own rounding is the test's.
Vec3 placed(const Scene& scene, std::size_t i) {
  const Vec3 p = scene.points.point(i);
  return {scene.middle.x + p.x, scene.middle.y + p.y, scene.middle.z + p.z};
}

constexpr double placing = 0x1p-51;

TEST(Feet, AreWithinTheBoundOfTheKernels) {
  test::on_every_instruction_set([] {
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
      const Scene scene(seed);
      alignas(64) double squared[RegionPoints::most];
      squared_distances({scene.frames, scene.numbers}, scene.points, squared);
      for (std::size_t first = 0; first < scene.points.count; first += Feet::most) {
        Feet feet;
        find_feet({scene.frames, scene.numbers}, scene.points, first, feet);
        for (std::size_t i = 0; i < std::min(Feet::most, scene.points.count - first); ++i) {
          const Vec3 p = placed(scene, first + i);
          double error = placing;
          const double truth = scene.least(p, error);
          ASSERT_EQ(std::sqrt(squared[first + i]), feet.distance[i]);
          ASSERT_NEAR(feet.distance[i], truth, error + placing) << "seed " << seed << " point " << first + i;
          // The foot is on the triangle that is named.
          if (!(feet.distance[i] > 2 * error)) continue;
          const double d = feet.distance[i];
          const Vec3 foot{p.x - d * feet.away[0][i], p.y - d * feet.away[1][i], p.z - d * feet.away[2][i]};
          const TriangleShape& shape = scene.shapes[static_cast<std::size_t>(feet.number[i])];
          ASSERT_LE(square_root(measure(foot, shape).squared), 4 * error + placing) << "seed " << seed;
        }
      }
    }
  });
}

TEST(Feet, NameThePlaceWhereItIsPlain) {
  const std::array<Vec3, 3> c{Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}};
  const TriangleShape shape{c, unit_normal(c[0], c[1], c[2])};
  const std::vector<TriangleFrame> frames{triangle_frame(shape, {0, 0, 0}, 2)};
  const std::vector<std::uint16_t> numbers{0};
  const struct {
    Vec3 p;
    double place;
  } cases[] = {{{0.2, 0.2, -1}, 0}, {{0.5, -1, 0}, 1}, {{1, 1, 0.5}, 2}, {{-1, 0.5, 0}, 3},
               {{-1, -1, 1}, 4},    {{2, -1, 0}, 5},   {{-1, 2, 1}, 6}};
  RegionPoints points;
  for (const auto& at : cases) points.add(at.p);
  Feet feet;
  find_feet({frames, numbers}, points, 0, feet);
  for (std::size_t i = 0; i < points.count; ++i) EXPECT_EQ(feet.place[i], cases[i].place) << i;
}

TEST(Feet, AreTheSameOnEveryInstructionSet) {
  const Scene scene(7);
  std::vector<unsigned char> first;
  test::on_every_instruction_set([&] {
    Feet feet;
    std::memset(&feet, 0, sizeof feet);
    find_feet({scene.frames, scene.numbers}, scene.points, 0, feet);
    std::vector<unsigned char> bytes(sizeof feet);
    std::memcpy(bytes.data(), &feet, sizeof feet);
    if (first.empty()) first = bytes;
    EXPECT_EQ(bytes, first);
  });
}

}  // namespace
}  // namespace cdfr
