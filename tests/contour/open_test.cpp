// Contours of fields whose sign comes from winding numbers: of open meshes, where the signed distance jumps
// off the surface and the contour ends there, and of bodies that cross.
#include <gtest/gtest.h>

#include <cmath>

#include "contour/case.h"
#include "contour/coverage.h"
#include "oracle/point_count.h"
#include "support/joined.h"
#include "support/meshes.h"

namespace cdfr {
namespace {

Mesh open_box() {
  Mesh mesh = test::box_mesh({{0, 0, 0}, {1, 1, 1}});
  mesh.triangles.erase(mesh.triangles.begin() + 2, mesh.triangles.begin() + 4);  // the top
  return mesh;
}

/// True points whose own distance is the contour's: the way from the foot did not come to the other side.
void expect_whole(const test::Case& part, double distance, double tolerance) {
  const test::Contour contour = test::contour_of(part.field, distance, tolerance);
  std::vector<Vec3> truth;
  for (const Vec3& x : test::true_contour(part, distance, test::scaled(part.field.bounds(), 2.5), 20000, 7)) {
    if (std::fabs(part.brute.closest(x).distance - distance) < 1e-12) truth.push_back(x);
  }
  ASSERT_GT(truth.size(), 100U) << distance;
  test::expect_covered(contour, truth);
  std::size_t ghosts = 0;
  for (const ContourPoint& p : contour.points) {
    if (std::isfinite(p.error))
      ghosts += std::fabs(part.brute.closest(p.position).distance - distance) > p.error + 1e-12;
  }
  EXPECT_EQ(ghosts, 0U) << distance;
  EXPECT_LE(contour.report.undecided, contour.points.size() / 50) << distance;
}

TEST(ContourOfOpenMesh, EndsWhereTheSignDoes) {
  const test::Case part(open_box());
  ASSERT_EQ(part.field.sign(), Sign::winding);
  for (const double distance : {-0.3, 0.25}) expect_whole(part, distance, 0.04);
}

TEST(ContourOfOpenMesh, OfACapAndOfASoupHasNoGhosts) {
  Mesh cap = test::sphere_mesh(2);
  std::erase_if(cap.triangles, [&](const Triangle& t) {
    return cap.vertices[t[0]].z + cap.vertices[t[1]].z + cap.vertices[t[2]].z < -0.6;
  });
  for (Vec3& v : cap.vertices) v = {v.x, 0.8 * v.y - 0.6 * v.z, 0.6 * v.y + 0.8 * v.z};
  const double tolerance = oracle::light_run() ? 0.16 : 0.08;
  expect_whole(test::Case(cap), 0.2, tolerance);
  expect_whole(test::Case(cap), -0.2, tolerance);
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    expect_whole(test::Case(test::soup(5, {{0, 0, 0}, {1, 1, 1}}, seed)), 0.1, tolerance);
  }
}

TEST(ContourOfOpenMesh, AtZeroIsTheSurface) {
  const test::Case part(open_box());
  const test::Contour contour = test::contour_of(part.field, 0, 0.05);
  for (const ContourPoint& p : contour.points) EXPECT_EQ(part.brute.closest(p.position).distance, 0);
  EXPECT_GT(contour.points.size(), 1000U);
  EXPECT_EQ(contour.report.undecided, 0U);
}

TEST(ContourOfCrossingBodies, GoesAroundInnerWallsToo) {
  const Mesh cube = test::box_mesh({{0, 0, 0}, {1, 1, 1}});
  const test::Case part(test::joined(cube, test::moved(cube, {0.5, 0.25, 0.375})));
  for (const double distance : {-0.15, 0.125}) expect_whole(part, distance, 0.04);
}

}  // namespace
}  // namespace cdfr
