#include "parts/delaunay.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <random>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "parts/plan.h"

namespace cdfr {
namespace {

__extension__ using Wide = __int128;

bool strictly_in_circle(PlanPoint a, PlanPoint b, PlanPoint c, PlanPoint p) {
  const auto lift = [&](PlanPoint q) {
    return static_cast<Wide>(q.x - p.x) * (q.x - p.x) + static_cast<Wide>(q.y - p.y) * (q.y - p.y);
  };
  return lift(a) * turn(p, b, c) + lift(b) * turn(p, c, a) + lift(c) * turn(p, a, b) > 0;
}

std::int64_t twice_area(const Delaunay& mesh) {
  std::int64_t sum = 0;
  for (const auto& [a, b, c] : mesh.triangles()) {
    const std::int64_t area = turn(mesh.points()[a], mesh.points()[b], mesh.points()[c]);
    EXPECT_GT(area, 0);
    sum += area;
  }
  return sum;
}

void expect_delaunay(const Delaunay& mesh) {
  for (const auto& [a, b, c] : mesh.triangles()) {
    for (const PlanPoint p : mesh.points()) {
      ASSERT_FALSE(strictly_in_circle(mesh.points()[a], mesh.points()[b], mesh.points()[c], p));
    }
  }
}

TEST(Delaunay, PointsOnTheBorderAndTwice) {
  Delaunay mesh({1000, 600});
  EXPECT_EQ(mesh.insert({0, 0}), 0U);
  const std::uint32_t border = mesh.insert({500, 0});
  EXPECT_EQ(mesh.insert({500, 0}), border);
  mesh.insert({0, 300});
  mesh.insert({1000, 1});
  mesh.insert({250, 600});
  mesh.insert({500, 300});  // on the first diagonal
  EXPECT_EQ(mesh.points().size(), 9U);
  EXPECT_EQ(twice_area(mesh), 2 * 1000 * 600);
  expect_delaunay(mesh);
}

/// A square grid: every four neighbours lie on a circle.
TEST(Delaunay, GridWhereEverythingIsCocircular) {
  Delaunay mesh({1600, 1600});
  for (int i = 0; i <= 16; ++i) {
    for (int j = 0; j <= 16; ++j) mesh.insert({100 * ((i * 7) % 17), 100 * ((j * 5) % 17)});
  }
  EXPECT_EQ(mesh.points().size(), 289U);
  EXPECT_EQ(mesh.triangles().size(), 512U);
  EXPECT_EQ(twice_area(mesh), 2 * 1600 * 1600);
  expect_delaunay(mesh);
}

TEST(Delaunay, RandomPointsUpToTheLargestCoordinate) {
  std::mt19937_64 random(5);
  const std::int64_t far = (1 << 20) - 1;
  Delaunay mesh({far, far});
  for (int i = 0; i < 300; ++i) {
    mesh.insert(
        {static_cast<std::int64_t>(random() % (far + 1)), static_cast<std::int64_t>(random() % (far + 1))});
  }
  for (int i = 0; i < 100; ++i) mesh.insert({far / 2 + i, far / 2 + i % 3});
  EXPECT_EQ(twice_area(mesh), 2 * far * far);
  expect_delaunay(mesh);
}

/// Every triangle of the plan is on one side of every outline: its area within them adds up to theirs.
TEST(Plan, HoldsEverySideOfOutlinesThatCross) {
  const PlanPoint far = plan_point(100, 60);
  const std::vector<Outline> outlines{rectangle(10, 10, 60, 40), disc(60, 25, 20, 32), disc(30, 40, 8, 16),
                                      rounded(70, 5, 95, 55, 6, 4)};
  const Plan plan = make_plan(far, outlines, 4);
  std::vector<double> inside(outlines.size(), 0);
  double all = 0;
  for (const auto& [a, b, c] : plan.triangles) {
    const auto area = static_cast<double>(turn(plan.points[a], plan.points[b], plan.points[c])) / 2;
    ASSERT_GT(area, 0);
    all += area;
    for (std::size_t i = 0; i < outlines.size(); ++i) {
      if (holds_middle(outlines[i], plan.points[a], plan.points[b], plan.points[c])) inside[i] += area;
    }
  }
  EXPECT_EQ(all, static_cast<double>(far.x * far.y));
  for (std::size_t i = 0; i < outlines.size(); ++i) {
    double area = 0;
    for (std::size_t k = 1; k + 1 < outlines[i].size(); ++k) {
      area += static_cast<double>(turn(outlines[i][0], outlines[i][k], outlines[i][k + 1])) / 2;
    }
    EXPECT_NEAR(inside[i] / area, 1, 1e-3) << i;
  }
}

TEST(Outline, LeftPartCutsAndKeeps) {
  const Outline whole = rectangle(0, 0, 10, 10);
  EXPECT_EQ(left_part(whole, plan_point(0, -5), plan_point(1, -5)), whole);
  EXPECT_TRUE(left_part(whole, plan_point(1, -5), plan_point(0, -5)).empty());
  const Outline half = left_part(whole, plan_point(0, 4), plan_point(1, 4));
  EXPECT_EQ(half, (Outline{plan_point(10, 4), plan_point(10, 10), plan_point(0, 10), plan_point(0, 4)}));
}

TEST(Outline, DiscsAreSymmetric) {
  const Outline outline = disc(100, 50, 13, 24);
  for (std::size_t i = 0; i < 24; ++i) {
    const PlanPoint opposite = outline[(i + 12) % 24];
    EXPECT_EQ(outline[i].x + opposite.x, 2 * plan_point(100, 0).x);
    EXPECT_EQ(outline[i].y + opposite.y, 2 * plan_point(0, 50).y);
  }
  EXPECT_EQ(outline[0], plan_point(113, 50));
  EXPECT_EQ(outline[6], plan_point(100, 63));
}

}  // namespace
}  // namespace cdfr
