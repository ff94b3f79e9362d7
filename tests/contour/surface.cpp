#include "contour/surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "cdfr/contour/contour.h"
#include "contour/surface_oracle.h"
#include "support/random.h"

namespace cdfr::test {

void expect_closed_manifold(const Mesh& mesh) {
  // next[v][a] = b: the triangle (v, a, b) turns about v from a to b.
  std::vector<std::map<std::uint32_t, std::uint32_t>> next(mesh.vertices.size());
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      ASSERT_LT(t[k], mesh.vertices.size());
      ASSERT_TRUE(next[t[k]].emplace(t[(k + 1) % 3], t[(k + 2) % 3]).second)
          << "an edge has two triangles in one direction";
    }
  }
  for (const auto& around : next) {
    ASSERT_FALSE(around.empty()) << "a vertex without triangles";
    const std::uint32_t first = around.begin()->first;
    std::uint32_t at = first;
    std::size_t steps = 0;
    do {
      const auto found = around.find(at);
      ASSERT_NE(found, around.end()) << "an open edge";
      at = found->second;
      ASSERT_LE(++steps, around.size());
    } while (at != first);
    ASSERT_EQ(steps, around.size()) << "a vertex with two fans";
  }
}

void expect_embedded(const Mesh& mesh) {
  if (mesh.triangles.empty()) return;
  const SurfaceVerdict verdict = judge_surface(mesh);
  EXPECT_TRUE(verdict.closed);
  EXPECT_FALSE(verdict.meets_itself);
  EXPECT_TRUE(verdict.bounds_volume);
}

ContourMesh surface_of(const Field& field, double distance, double tolerance) {
  ContourMesh contour = contour_mesh(field, distance, {tolerance}).value();
  const ContourMeshReport& report = contour.report;
  EXPECT_EQ(report.vertices, contour.mesh.vertices.size());
  EXPECT_EQ(report.triangles, contour.mesh.triangles.size());
  EXPECT_EQ(report.places.size(), report.crowded + report.undecided + report.loose);
  EXPECT_TRUE(tolerance == 0 || report.tolerance == tolerance);
  EXPECT_EQ(report.box.lo.x > report.box.hi.x, contour.mesh.vertices.empty());
  EXPECT_TRUE(report.loose > 0 || report.largest_error <= report.tolerance) << report.largest_error;
  expect_closed_manifold(contour.mesh);
  expect_embedded(contour.mesh);
  return contour;
}

namespace {

template <class SignedDistance>
double largest_excess_of(SignedDistance signed_distance, const Mesh& mesh, double distance,
                         std::size_t count) {
  Random random(71);
  double largest = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const Triangle& t = mesh.triangles[i * mesh.triangles.size() / count];
    double u = random.between(0, 1), w = random.between(0, 1);
    if (u + w > 1) {
      u = 1 - u;
      w = 1 - w;
    }
    const Vec3 a = mesh.vertices[t[0]], b = mesh.vertices[t[1]], c = mesh.vertices[t[2]];
    const Vec3 x{a.x + u * (b.x - a.x) + w * (c.x - a.x), a.y + u * (b.y - a.y) + w * (c.y - a.y),
                 a.z + u * (b.z - a.z) + w * (c.z - a.z)};
    largest = std::max(largest, std::fabs(signed_distance(x) - distance));
  }
  return largest;
}

bool is_listed(const Vec3& x, std::span<const ContourPlace> places, double within) {
  return std::ranges::any_of(places, [&](const ContourPlace& place) {
    const Vec3& p = place.position;
    return place.doubt == ContourDoubt::undecided &&
           std::max({std::fabs(x.x - p.x), std::fabs(x.y - p.y), std::fabs(x.z - p.z)}) <=
               place.size / 2 + within;
  });
}

}  // namespace

double largest_excess(const Field& field, const Mesh& mesh, double distance, std::size_t count) {
  return largest_excess_of([&](const Vec3& x) { return field.distance(x); }, mesh, distance, count);
}

double largest_excess(const BruteForce& brute, const Mesh& mesh, double distance, std::size_t count) {
  return largest_excess_of([&](const Vec3& x) { return brute.closest(x).distance; }, mesh, distance, count);
}

double largest_gap(const Field& field, const Mesh& mesh, double distance, double spacing,
                   std::span<const ContourPlace> places) {
  BuildOptions options;
  options.sign = Sign::none;
  const Field of_mesh = Field::build(mesh.view(), options).value();
  double largest = 0;
  const std::vector<ContourPoint> points = contour_points(field, distance, {spacing}).value();
  for (const ContourPoint& point : points) {
    if (!std::isfinite(point.error)) continue;
    const double gap = of_mesh.distance(point.position);
    if (gap > largest && !is_listed(point.position, places, spacing)) largest = gap;
  }
  return largest;
}

double volume_of(const Mesh& mesh) { return audit(mesh.view()).value().volume; }

}  // namespace cdfr::test
