#include "parts/triangulation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace cdfr {
namespace {

std::int64_t twice_area(const Outline& outline) {
  std::int64_t sum = 0;
  for (std::size_t i = 1; i + 1 < outline.size(); ++i) sum += turn(outline[0], outline[i], outline[i + 1]);
  return sum;
}

/// Triangles that all turn left, use each loop's sides and have the polygon's area in all cover it once.
void expect_covers(const std::vector<Outline>& loops) {
  std::vector<PlanPoint> points;
  std::vector<std::array<std::uint32_t, 2>> border;
  std::int64_t left = 0;
  for (const Outline& loop : loops) {
    const auto first = static_cast<std::uint32_t>(points.size());
    const auto count = static_cast<std::uint32_t>(loop.size());
    for (std::uint32_t i = 0; i < count; ++i) {
      const std::uint32_t here = first + i, next = first + (i + 1) % count;
      border.push_back(first == 0 ? std::array{here, next} : std::array{next, here});
    }
    left += first == 0 ? twice_area(loop) : -twice_area(loop);
    points.insert(points.end(), loop.begin(), loop.end());
  }
  const auto triangles = triangulate(loops);
  EXPECT_EQ(triangles.size(), points.size() + 2 * (loops.size() - 1) - 2);
  std::vector<std::array<std::uint32_t, 2>> sides;
  for (const auto& [a, b, c] : triangles) {
    const std::int64_t area = turn(points[a], points[b], points[c]);
    EXPECT_GT(area, 0);
    left -= area;
    sides.insert(sides.end(), {{a, b}, {b, c}, {c, a}});
  }
  EXPECT_EQ(left, 0);
  std::sort(sides.begin(), sides.end());
  EXPECT_EQ(std::adjacent_find(sides.begin(), sides.end()), sides.end());
  for (const auto& side : border) EXPECT_TRUE(std::binary_search(sides.begin(), sides.end(), side));
}

TEST(Triangulation, TriangleAndSquare) {
  expect_covers({{{0, 0}, {5, 0}, {0, 3}}});
  expect_covers({rectangle(0, 0, 10, 10)});
}

TEST(Triangulation, CornersOnAStraightLine) {
  expect_covers({{{0, 0}, {1, 0}, {2, 0}, {7, 0}, {7, 7}, {7, 9}, {0, 9}, {0, 4}}});
  expect_covers({{{0, 0}, {9, 0}, {9, 9}, {8, 8}, {5, 5}, {1, 1}}});
}

TEST(Triangulation, NotConvex) {
  expect_covers({{{0, 0}, {9, 0}, {9, 9}, {8, 9}, {8, 1}, {1, 1}, {1, 9}, {0, 9}}});
  expect_covers({{{0, 0}, {10, 5}, {20, 0}, {15, 10}, {20, 20}, {10, 15}, {0, 20}, {5, 10}}});
}

/// The sides of a hole of three corners make a triangle that is none of the polygon's.
TEST(Triangulation, HolesOfThreeCorners) {
  expect_covers({{{0, 0}, {9, 0}, {0, 9}}, {{1, 1}, {3, 1}, {1, 3}}});
  expect_covers({{{0, 0}, {99, 0}, {0, 99}}, {{1, 1}, {30, 1}, {1, 30}}, {{31, 31}, {33, 31}, {31, 33}}});
}

TEST(Triangulation, HolesInRowsAsEquallyFarApart) {
  std::vector<Outline> loops{rectangle(0, 0, 55, 55)};
  for (int x = 5; x < 50; x += 10) {
    for (int y = 5; y < 50; y += 10) loops.push_back(rectangle(x, y, x + 5, y + 5));
  }
  expect_covers(loops);
}

TEST(Triangulation, RoundHolesUpToTheLargestCoordinate) {
  expect_covers({rounded(0, 0, 1023, 1023, 100, 8), disc(300, 300, 150, 48), disc(700, 320, 200, 32),
                 disc(400, 750, 10, 64), rounded(600, 600, 900, 900, 50, 4), disc(500, 500, 1, 6)});
}

}  // namespace
}  // namespace cdfr
