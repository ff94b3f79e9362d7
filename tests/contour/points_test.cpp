// Promise 5, no hole and no ghost: every point lies on the true contour, and every point of the true contour
// has one within the tolerance. Brute force says what is true.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "cdfr/parts/part.h"
#include "contour/case.h"
#include "contour/coverage.h"
#include "support/meshes.h"
#include "support/random.h"

namespace cdfr {
namespace {

using test::Case;
using test::Contour;

/// Checks one contour whole; returns how many points it has.
std::size_t check(const Case& part, double distance, double tolerance, std::size_t stride = 1) {
  const Contour contour = test::contour_of(part.field, distance, tolerance);
  EXPECT_EQ(contour.report.undecided, 0U);
  test::expect_true_points(part, contour, stride);
  // From the mesh's box, or for the outside a larger one, and from close by, where small contours are met.
  const Box box = part.field.bounds();
  const double longest = std::max({box.hi.x - box.lo.x, box.hi.y - box.lo.y, box.hi.z - box.lo.z});
  Box around = box;
  if (distance > 0) {
    const double by = distance + 0.3 * longest;
    around = {{box.lo.x - by, box.lo.y - by, box.lo.z - by}, {box.hi.x + by, box.hi.y + by, box.hi.z + by}};
  }
  std::vector<Vec3> truth = test::true_contour(part, distance, around, 1500, 77);
  const std::vector<Vec3> near =
      test::true_contour(part, distance, test::scaled(contour.report.box, 1.1), 1500, 78);
  truth.insert(truth.end(), near.begin(), near.end());
  test::expect_covered(contour, truth);
  return contour.points.size();
}

TEST(ContourPoints, OfASphereInsideAndOutside) {
  const Case sphere(test::sphere_mesh(3));
  for (const double distance : {-0.9, -0.5, -0.01, 0.04, 0.3}) check(sphere, distance, 0.13, 11);
}

TEST(ContourPoints, OfASphereNearItsCentreWhereAllTrianglesAreEquallyFar) {
  const Case sphere(test::sphere_mesh(3));
  const double depth = -sphere.brute.closest({0, 0, 0}).distance;
  ASSERT_GT(depth, 0.95);
  EXPECT_GT(check(sphere, -depth * (1 - 1e-3), 0.01), 0U);
}

TEST(ContourPoints, OfACubeInsideAndOutside) {
  const Case cube(test::box_mesh({{0.1, -0.2, 0.3}, {1.1, 0.8, 1.3}}));
  for (const double distance : {-0.49, -0.3, -1e-3, 1e-3, 0.2}) check(cube, distance, 0.083, 2);
}

TEST(ContourPoints, OfACubeOnTheLatticeItself) {
  const Case cube(test::box_mesh({{0, 0, 0}, {1, 1, 1}}));
  for (const double distance : {-0.375, -0.25, -0x1p-10, 0.0, 0.25}) check(cube, distance, 0x1p-4);
}

/// The contour is the plate's middle sheet, or is not there, as the last bits have it. No sample can tell, so
/// none should be looked for.
TEST(ContourPoints, AtTheDepthOfAMedialSheetTakeFewDistances) {
  for (const double at : {0.0, 0.1, 1.0 / 3, 1e3 / 7}) {
    const Case plate(test::box_mesh({{at, 0.2, 0.3}, {at + 1.0 / 7, 4.3, 5.1}}));
    const double depth = -plate.brute.closest({at + 0.5 / 7, 2, 2}).distance;
    for (int step = -20; step <= 20; step += 8) {
      const double t = depth + step * 0x1p-52 * (at + 1);
      const ContourReport report = test::contour_of(plate.field, -t, 0.6).report;
      EXPECT_LT(report.evaluations, 1000 * std::max<std::uint64_t>(report.points, 100)) << at << " " << step;
    }
  }
}

/// A plate of thickness |n| on a triangle at right angles to n, all coordinates integers.
Mesh tilted_plate(const Vec3& n, double at) {
  const Vec3 u{10 * n.y, -10 * n.x, 0}, v{2 * n.x * n.z, 2 * n.y * n.z, -2 * (n.x * n.x + n.y * n.y)};
  Mesh mesh;
  for (const Vec3& low :
       {Vec3{at, at, at}, Vec3{at + v.x, at + v.y, at + v.z}, Vec3{at + u.x, at + u.y, at + u.z}}) {
    mesh.vertices.push_back(low);
    mesh.vertices.push_back({low.x + n.x, low.y + n.y, low.z + n.z});
  }
  mesh.triangles = {{0, 2, 4}, {1, 5, 3}, {0, 3, 2}, {0, 1, 3}, {2, 5, 4}, {2, 3, 5}, {4, 1, 0}, {4, 5, 1}};
  return mesh;
}

/// Half a rounding decides whether the sheet in the middle is there: then nearly all of it is found, and no
/// point is promised that is not.
TEST(ContourPoints, AtATiltedSheetAreThereIfItIs) {
  for (const Vec3& n : {Vec3{1, 2, 3}, Vec3{4, 1, 2}, Vec3{5, 3, 1}, Vec3{2, 5, 5}}) {
    const Case plate(tilted_plate(n, 700));
    ASSERT_EQ(plate.field.sign(), Sign::pseudonormal);
    const double depth = std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z) / 2;
    const double half_rounding = 8 * 0x1p-43;  // of sixteen ulp of coordinates below 1024
    const Contour there = test::contour_of(plate.field, -(depth - half_rounding), 3.3);
    EXPECT_GT(there.report.points, 50U);
    EXPECT_LE(there.report.undecided, there.report.points / 50);
    const Contour gone = test::contour_of(plate.field, -(depth + half_rounding), 3.3);
    EXPECT_EQ(gone.report.undecided, gone.report.points);
  }
}

TEST(ContourPoints, OfATwoDegreeWedge) {
  const Case wedge(test::wedge_mesh());
  for (const double distance : {-0.025, -0.01, 0.02}) check(wedge, distance, 0.097, 3);
}

TEST(ContourPoints, OfConcaveParts) {
  for (const char* name : {"one-tooth", "six-star", "tetrahedron"}) {
    SCOPED_TRACE(name);
    const Case part(make_part(name).value());
    for (const double distance : {-0.15, -0.02, 0.1}) check(part, distance, 0.09, 5);
  }
}

/// Two cubes in one mesh: between them the contour has a saddle, and the medial axis outside bounds both.
TEST(ContourPoints, BetweenTwoBodies) {
  Mesh mesh = test::box_mesh({{0, 0, 0}, {1, 1, 1}});
  const Mesh second = test::box_mesh({{1.3, 0, 0}, {2.3, 1, 1}});
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), second.vertices.begin(), second.vertices.end());
  for (const Triangle& f : second.triangles)
    mesh.triangles.push_back({f[0] + first, f[1] + first, f[2] + first});
  const Case pair(std::move(mesh));
  for (const double distance : {0.149, 0.151, 0.4}) check(pair, distance, 0.11, 5);
}

TEST(ContourPoints, AtZeroGiveTheSurfaceBack) {
  const Case sphere(test::sphere_mesh(2, 1, {3, -2, 1}));
  const Contour contour = test::contour_of(sphere.field, 0, 0.07);
  test::expect_true_points(sphere, contour, 7);
  test::Random random(5);
  std::vector<Vec3> surface;
  for (int i = 0; i < 3000; ++i) {
    const Triangle& f = sphere.mesh.triangles[random.below(sphere.mesh.triangles.size())];
    double a = random.between(0, 1), b = random.between(0, 1);
    if (a + b > 1) a = 1 - a, b = 1 - b;
    const Vec3 p = sphere.mesh.vertices[f[0]], q = sphere.mesh.vertices[f[1]], r = sphere.mesh.vertices[f[2]];
    surface.push_back({p.x + a * (q.x - p.x) + b * (r.x - p.x), p.y + a * (q.y - p.y) + b * (r.y - p.y),
                       p.z + a * (q.z - p.z) + b * (r.z - p.z)});
  }
  test::expect_covered(contour, surface);
}

/// Away from the cube's edges and diagonals the gradient is known.
TEST(ContourPoints, CarryTheGradient) {
  const Case cube(test::box_mesh({{-1, -1, -1}, {1, 1, 1}}));
  for (const double distance : {-0.4, 0.0, 0.3}) {
    std::size_t told = 0;
    for (const ContourPoint& p : test::contour_of(cube.field, distance, 0.09).points) {
      const double x = std::fabs(p.position.x), y = std::fabs(p.position.y), z = std::fabs(p.position.z);
      if (!(x < 1 && y < z - 1e-3 && x < z - 1e-3 && y < 1)) continue;
      ++told;
      EXPECT_EQ(p.normal, (Vec3{0, 0, p.position.z > 0 ? 1.0 : -1.0}));
      EXPECT_EQ(p.normal, cube.field.closest(p.position).gradient);
    }
    EXPECT_GT(told, 100U);
  }
}

TEST(ContourPoints, SurviveMoveAndScaleByPowersOfTwo) {
  const Mesh near = test::sphere_mesh(2);
  Mesh far = near;
  for (Vec3& v : far.vertices) v = {v.x * 0x1p30 + 0x1p34, v.y * 0x1p30, v.z * 0x1p30};
  const Case moved(std::move(far));
  check(moved, -0.3 * 0x1p30, 0.2 * 0x1p30, 3);
  Mesh small = near;
  for (Vec3& v : small.vertices) v = {v.x * 0x1p-60, v.y * 0x1p-60, v.z * 0x1p-60};
  const Case shrunk(std::move(small));
  check(shrunk, -0.3 * 0x1p-60, 0.2 * 0x1p-60, 3);
}

}  // namespace
}  // namespace cdfr
