// Contours beyond the field's domain, and far beyond it.
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>

#include "contour/case.h"
#include "contour/coverage.h"
#include "support/meshes.h"
#include "support/random.h"

namespace cdfr {
namespace {

using test::Case;
using test::Contour;

const Box unit_box{{0, 0, 0}, {1, 1, 1}};

TEST(ContourBeyond, HasNoSeamAtTheDomain) {
  BuildOptions tight;
  tight.margin = 0;
  const Case cube(test::box_mesh({{0.01, 0.02, 0.03}, {1, 0.7, 0.5}}), tight);
  const Box domain = cube.field.domain();
  for (const double distance : {1e-3, 0.02, 0.1, 0.2}) {
    const Contour contour = test::contour_of(cube.field, distance, 0.06);
    EXPECT_EQ(contour.report.undecided, 0U);
    test::expect_true_points(cube, contour, 3);
    test::expect_covered(contour, test::true_contour(cube, distance, test::scaled(domain, 2), 5000, 21));
  }
}

TEST(ContourBeyond, ThreeTimesTheBoxAway) {
  const Case sphere(test::sphere_mesh(2, 0.5, {7, 0, 0}));
  const Contour contour = test::contour_of(sphere.field, 3, 0.4);
  EXPECT_EQ(contour.report.undecided, 0U);
  EXPECT_EQ(contour.report.visited, 0U);
  test::expect_true_points(sphere, contour, 13);
  test::expect_covered(contour,
                       test::true_contour(sphere, 3, test::scaled(sphere.field.bounds(), 12), 3000, 22));
}

/// Few points are asked for: the search may not cost as many steps as there are leaf-sized cubes on a sphere
/// of that radius.
TEST(ContourBeyond, CostsWhatItsToleranceAsksFor) {
  const Case cube(test::box_mesh(unit_box));
  const double distance = 20;
  const Contour contour = test::contour_of(cube.field, distance, 10);
  test::expect_true_points(cube, contour, 1 + contour.points.size() / 5000);
  test::expect_covered(contour, test::true_contour(cube, distance, test::scaled(unit_box, 60), 2000, 23));
  EXPECT_LT(contour.report.evaluations, 20000U);
}

TEST(ContourBeyond, SearchOutsideTheDomainCanBeCancelled) {
  const Case cube(test::box_mesh(unit_box));
  std::atomic<int> ticks = 0;
  cdfr::Run run;
  run.context = &ticks;
  run.tick = [](void* context, double) noexcept {
    ++*static_cast<std::atomic<int>*>(context);
    return false;
  };
  const auto result = contour_points(cube.field, 20, {0.5}, run);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, Code::cancelled);
  EXPECT_EQ(ticks, 1);
}

}  // namespace
}  // namespace cdfr
