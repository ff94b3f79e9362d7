// Meshes where many triangles are equally close or lie in one place: no split shortens the lists for ever, so
// a build that only looks at their length never ends, or ends when memory does.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <string>

#include "cdfr/field/field.h"
#include "oracle/point_count.h"
#include "support/meshes.h"
#include "support/same.h"

namespace cdfr {
namespace {

/// A field stays below 16 MiB and 4 KiB a triangle, above the depth limit, and answers as brute force does:
/// at `special`, near it and anywhere.
void expect_bounded_and_right(const Mesh& mesh, const BuildOptions& options, const Vec3& special) {
  const Field field = Field::build(mesh.view(), options).value();
  const Stats stats = field.stats();
  EXPECT_LE(stats.levels.size(), static_cast<std::size_t>(field.options().max_level) + 1);
  EXPECT_LE(stats.bytes, (16U << 20) + (std::uint64_t{4} << 10) * mesh.triangles.size());
  testing::Test::RecordProperty("bytes", std::to_string(stats.bytes));
  const BruteForce brute = BruteForce::over(mesh.view()).value();
  ASSERT_TRUE(test::same_bits(field.closest(special), brute.closest(special)));
  test::Random random(41);
  for (int i = 0; i < 60; ++i) {
    const double size = std::ldexp(1.5, -static_cast<int>(random.below(40)));
    const Vec3 off = random.in({{-size, -size, -size}, {size, size, size}});
    const Vec3 p{special.x + off.x, special.y + off.y, special.z + off.z};
    ASSERT_TRUE(test::same_bits(field.closest(p), brute.closest(p))) << p.x << ' ' << p.y << ' ' << p.z;
  }
}

BuildOptions with_depth(int level) {
  BuildOptions options;
  options.max_level = level;
  return options;
}

/// Two million triangles in long runs, 32,768 else, 8,192 in light ones.
int ball_divisions() { return oracle::light_run() ? 5 : oracle::short_run() ? 6 : 9; }

TEST(EqualDistances, ABallWithItsCentreInACell) {
  const Vec3 centre{0.01, 0.02, 0.03};
  expect_bounded_and_right(test::sphere_mesh(ball_divisions(), 1, centre), {}, centre);
}

TEST(EqualDistances, ABallWithItsCentreOnACorner) {
  expect_bounded_and_right(test::sphere_mesh(ball_divisions()), {}, {0, 0, 0});
}

TEST(EqualDistances, ABallAtTheGreatestDepth) {
  for (const Vec3& centre : {Vec3{0, 0, 0}, Vec3{0.01, 0.02, 0.03}}) {
    expect_bounded_and_right(test::sphere_mesh(4, 1, centre), with_depth(18), centre);
  }
}

TEST(EqualDistances, TrianglesThatAllCrossEachOther) {
  const std::size_t count = oracle::short_run() ? 2000 : 100'000;
  expect_bounded_and_right(test::soup(count, {{0, 0, 0}, {1, 1, 1}}, 42), {}, {0.5, 0.5, 0.5});
}

/// All triangles have a corner in one point, and their others all around it.
TEST(EqualDistances, TrianglesThatAllMeetInOnePoint) {
  const std::uint32_t count = oracle::short_run() ? 2000 : 100'000;
  Mesh mesh = test::soup(count, {{-1, -1, -1}, {1, 1, 1}}, 43);
  for (std::uint32_t i = 0; i < count; ++i) mesh.vertices[3 * i] = {0, 0, 0};
  expect_bounded_and_right(mesh, {}, {0, 0, 0});
}

/// Nothing but points, all the same.
TEST(EqualDistances, TrianglesThatAreAllOnePoint) {
  const Vec3 at{1, 2, 3};
  Mesh mesh;
  mesh.vertices = {at, at, at};
  mesh.triangles.assign(oracle::short_run() ? 20'000 : 1'000'000, {0, 1, 2});
  expect_bounded_and_right(mesh, with_depth(18), at);
}

TEST(EqualDistances, OneTriangle) {
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0.3, 0.7, 0.1}};
  mesh.triangles = {{0, 1, 2}};
  BuildOptions options = with_depth(18);
  options.max_triangles_per_leaf = 1;
  expect_bounded_and_right(mesh, options, {0.3, 0.2, 0.1});
}

}  // namespace
}  // namespace cdfr
