#include "render/spacing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace cdfr {
namespace {

std::vector<ContourPoint> tilted_grid(int side, double step) {
  std::vector<ContourPoint> points;
  for (int i = 0; i < side; ++i) {
    for (int k = 0; k < side; ++k) {
      // Unit vectors (1, 2, 2)/3 and (2, 1, -2)/3 span the plane.
      const double u = i * step / 3, v = k * step / 3;
      points.push_back({{u + 2 * v, 2 * u + v, 2 * u - 2 * v}, {}, 0, 0});
    }
  }
  return points;
}

Box box_of(const std::vector<ContourPoint>& points) {
  Box box{points[0].position, points[0].position};
  for (const ContourPoint& point : points) {
    const Vec3 p = point.position;
    box = {{std::min(box.lo.x, p.x), std::min(box.lo.y, p.y), std::min(box.lo.z, p.z)},
           {std::max(box.hi.x, p.x), std::max(box.hi.y, p.y), std::max(box.hi.z, p.z)}};
  }
  return box;
}

TEST(SpacingTest, TooFewPointsHaveNone) {
  EXPECT_EQ(spacing_on_surface({}, {}), 0);
  const std::vector<ContourPoint> same(100, ContourPoint{{1, 2, 3}, {}, 0, 0});
  EXPECT_EQ(spacing_on_surface(same, box_of(same)), 0);
}

TEST(SpacingTest, FindsTheStepOfAGridInAnyOrder) {
  for (const double step : {1e-9, 0.25, 1e6}) {
    for (const int side : {10, 50, 300}) {
      auto points = tilted_grid(side, step);
      const double spacing = spacing_on_surface(points, box_of(points));
      EXPECT_GT(spacing, 0.6 * step) << side;
      EXPECT_LT(spacing, 1.6 * step) << side;
      std::reverse(points.begin(), points.end());
      EXPECT_EQ(spacing_on_surface(points, box_of(points)), spacing);
    }
  }
}

}  // namespace
}  // namespace cdfr
