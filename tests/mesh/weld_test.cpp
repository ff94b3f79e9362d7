#include "cdfr/mesh/weld.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <numeric>
#include <tuple>

#include "cdfr/mesh/audit.h"
#include "cdfr/mesh/read.h"
#include "mesh/samples.h"
#include "support/meshes.h"

namespace cdfr {
namespace {

using Corners = std::array<Vec3, 3>;

Corners corners_of(const Mesh& mesh, std::size_t triangle) {
  const Triangle& t = mesh.triangles[triangle];
  return {mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]};
}

/// Every triangle with corners of its own, each up to `crack` off along every axis.
Mesh cracked(const Mesh& mesh, double crack, std::uint64_t seed) {
  test::Random random(seed);
  Mesh apart;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (Vec3 p : corners_of(mesh, t)) {
      for (double* x : {&p.x, &p.y, &p.z}) *x += random.between(-crack, crack);
      apart.vertices.push_back(p);
    }
    const auto first = static_cast<std::uint32_t>(3 * t);
    apart.triangles.push_back({first, first + 1, first + 2});
  }
  return apart;
}

Mesh cube() {
  Mesh mesh;
  mesh.vertices = samples::cube_vertices();
  mesh.triangles = samples::cube_triangles();
  return mesh;
}

double distance(const Vec3& a, const Vec3& b) { return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z); }

/// The triangles as sets of places, in an order of their own.
std::vector<std::array<std::array<double, 3>, 3>> places(const Mesh& mesh) {
  std::vector<std::array<std::array<double, 3>, 3>> result;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Corners c = corners_of(mesh, t);
    result.push_back({{{c[0].x, c[0].y, c[0].z}, {c[1].x, c[1].y, c[1].z}, {c[2].x, c[2].y, c[2].z}}});
  }
  std::sort(result.begin(), result.end());
  return result;
}

/// What weld promises of any mesh.
void expect_promises(const Mesh& before, const Welded& after, double tolerance) {
  const Mesh& mesh = after.mesh;
  ASSERT_EQ(mesh.triangles.size(), after.numbers.size());
  EXPECT_EQ(mesh.triangles.size() + after.report.collapsed_triangles, before.triangles.size());
  EXPECT_TRUE(std::is_sorted(after.numbers.begin(), after.numbers.end()));
  const double limit = tolerance * (1 + 1e-14);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Corners from = corners_of(before, after.numbers[t]), to = corners_of(mesh, t);
    for (int k = 0; k < 3; ++k) EXPECT_LE(distance(from[k], to[k]), limit);
    EXPECT_TRUE(to[0] != to[1] && to[1] != to[2] && to[2] != to[0]);
  }
  EXPECT_LE(after.report.largest_move, limit);
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      ASSERT_GT(distance(mesh.vertices[i], mesh.vertices[j]), tolerance * (1 - 1e-14));
    }
  }
}

TEST(Weld, RefusesTolerancesByName) {
  const Mesh mesh = cube();
  for (const double bad : {-1e-9, -std::numeric_limits<double>::infinity(), std::nan(""),
                           std::numeric_limits<double>::infinity(), 0.0101, 1e300}) {
    const auto welded = weld(mesh, bad);
    ASSERT_FALSE(welded) << bad;
    EXPECT_EQ(welded.error().code, Code::bad_option);
    EXPECT_FALSE(welded.error().text.empty());
  }
  EXPECT_TRUE(weld(mesh, 0.01));
  EXPECT_TRUE(weld(mesh, -0.0));
  EXPECT_TRUE(weld(mesh, 5e-324));
}

TEST(Weld, RefusesWhatTheAuditRefuses) {
  Mesh mesh = cube();
  mesh.triangles[5][1] = 8;
  EXPECT_EQ(weld(mesh, 0).error().code, Code::bad_index);
  EXPECT_EQ(weld(mesh, 0).error().where, 5U);
  for (const auto& [x, code] :
       {std::pair{std::nan(""), Code::not_finite}, std::pair{0x1p201, Code::out_of_range}}) {
    mesh = cube();
    mesh.vertices[6].z = x;
    EXPECT_EQ(weld(mesh, 0).error().code, code);
    EXPECT_EQ(weld(mesh, 0).error().where, 6U);
  }
  EXPECT_EQ(weld({}, 0).error().code, Code::empty_mesh);
  mesh = cube();
  mesh.patches = {1, 2};
  EXPECT_EQ(weld(mesh, 0).error().code, Code::bad_option);
}

TEST(Weld, ACrackedCubeCloses) {
  const Mesh apart = cracked(cube(), 1e-4, 5);
  EXPECT_EQ(audit(apart.view()).value().open_edges, 36U);
  const Welded welded = weld(apart, 4e-4).value();
  expect_promises(apart, welded, 4e-4);
  const MeshReport report = audit(welded.mesh.view()).value();
  EXPECT_TRUE(report.closed());
  EXPECT_EQ(report.vertices, 8U);
  EXPECT_EQ(welded.mesh.vertices.size(), 8U);
  EXPECT_EQ(welded.report.merged_vertices, 36U - 8U);
  EXPECT_EQ(welded.report.collapsed_triangles, 0U);
}

TEST(Weld, ToleranceZeroJoinsWhatIsEqualAndNothingElse) {
  const Mesh apart = cracked(cube(), 0, 1);
  Welded welded = weld(apart, 0).value();
  EXPECT_EQ(welded.mesh.vertices.size(), 8U);
  EXPECT_EQ(welded.report.merged_vertices, 0U);
  EXPECT_EQ(places(welded.mesh), places(apart));
  Mesh zeros = apart;
  for (std::size_t i = 0; i < zeros.vertices.size(); i += 2) {
    for (double* x : {&zeros.vertices[i].x, &zeros.vertices[i].y, &zeros.vertices[i].z}) {
      if (*x == 0) *x = -0.0;
    }
  }
  EXPECT_EQ(weld(zeros, 0)->mesh.vertices.size(), 8U);
  Mesh off = apart;
  off.vertices[4].x = std::nextafter(off.vertices[4].x, 2);
  for (const double tolerance : {0.0, 5e-324, 0x1p-254}) {
    EXPECT_EQ(weld(off, tolerance)->mesh.vertices.size(), 9U) << tolerance;
  }
}

TEST(Weld, TheToleranceIsComparedExactly) {
  // 3^2 + 4^2 + 12^2 = 13^2; an ulp less does not reach.
  for (const double scale : {1.0, 0x1p-190, 0x1p180}) {
    Mesh mesh;
    mesh.vertices = {{3 * scale, 4 * scale, 12 * scale},
                     {2e3 * scale, 0, 0},
                     {0, 2e3 * scale, 0},
                     {0, 0, 0},
                     {2e3 * scale, 0, 0},
                     {0, 0, 2e3 * scale}};
    mesh.triangles = {{0, 1, 2}, {3, 4, 5}};
    EXPECT_EQ(weld(mesh, 13 * scale)->report.merged_vertices, 1U);
    EXPECT_EQ(weld(mesh, 13 * scale)->report.largest_move, 13 * scale);
    EXPECT_EQ(weld(mesh, std::nextafter(13 * scale, 0))->report.merged_vertices, 0U);
  }
}

TEST(Weld, AChainIsNotDraggedAlong) {
  Mesh mesh;
  mesh.vertices = {{0, 500, 0}, {0, 0, 500}};
  for (std::uint32_t i = 0; i < 1000; ++i) {
    mesh.vertices.push_back({i * 0.75, 0, 0});
    mesh.triangles.push_back({0, 1, 2 + i});
  }
  const Welded welded = weld(mesh, 1).value();
  expect_promises(mesh, welded, 1);
  EXPECT_EQ(welded.report.merged_vertices, 500U);
  EXPECT_EQ(welded.report.collapsed_triangles, 0U);
}

TEST(Weld, EachGoesToTheNearestKept) {
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0.5625, 0, 0}, {0, 400, 0}, {400, 0, 0}};
  mesh.triangles = {{0, 3, 4}, {1, 3, 4}, {2, 3, 4}};
  const Welded welded = weld(mesh, 0.75).value();
  EXPECT_EQ(corners_of(welded.mesh, 2)[0], (Vec3{1, 0, 0}));
  EXPECT_EQ(welded.report.largest_move, 0.4375);
}

TEST(Weld, CollapsedTrianglesAreDroppedAndDuplicatesKept) {
  Mesh mesh = cube();
  mesh.vertices.push_back({0, 0, 0x1p-10});
  mesh.vertices.push_back({9, 9, 9});  // no triangle uses it
  mesh.triangles.push_back({0, 8, 1});
  mesh.triangles.push_back({3, 3, 2});
  mesh.triangles.push_back(mesh.triangles[4]);
  mesh.patches.resize(15);
  std::iota(mesh.patches.begin(), mesh.patches.end(), 100U);
  mesh.patch_names = {"one", "two"};
  const Welded welded = weld(mesh, 0x1p-9).value();
  expect_promises(mesh, welded, 0x1p-9);
  EXPECT_EQ(welded.report.collapsed_triangles, 2U);
  EXPECT_EQ(welded.mesh.vertices.size(), 8U);
  ASSERT_EQ(welded.mesh.triangles.size(), 13U);
  EXPECT_EQ(welded.numbers.back(), 14U);
  EXPECT_EQ(welded.mesh.patches.back(), 114U);
  EXPECT_EQ(welded.mesh.patch_names, mesh.patch_names);
  EXPECT_EQ(audit(welded.mesh.view())->duplicate_triangles, 1U);
}

TEST(Weld, DoesNotDependOnTheOrderOfVerticesAndTriangles) {
  test::Random random(8);
  const Mesh mesh = test::soup(1500, {{-1, -1, -1}, {1, 1, 1}}, 3);
  const Welded welded = weld(mesh, 0.0175).value();
  expect_promises(mesh, welded, 0.0175);
  EXPECT_GT(welded.report.merged_vertices, 10U);
  Mesh shuffled = mesh;
  std::vector<std::uint32_t> place(mesh.vertices.size());
  std::iota(place.begin(), place.end(), 0U);
  for (std::size_t i = place.size(); i > 1; --i) std::swap(place[i - 1], place[random.below(i)]);
  for (std::size_t i = 0; i < place.size(); ++i) shuffled.vertices[place[i]] = mesh.vertices[i];
  for (Triangle& t : shuffled.triangles) t = {place[t[0]], place[t[1]], place[t[2]]};
  std::reverse(shuffled.triangles.begin(), shuffled.triangles.end());
  EXPECT_EQ(places(weld(shuffled, 0.0175)->mesh), places(welded.mesh));
}

TEST(Weld, HoldsItsPromisesAtAnyScaleAndPlace) {
  test::Random random(21);
  for (const double scale : {0x1p-190, 1.0, 0x1p190}) {
    const Mesh mesh = test::soup(150, {{-scale, -scale, 0}, {scale, scale, scale}}, random.bits());
    for (const double share : {0.0, 1e-9, 0.005, 0.0175}) {
      const auto welded = weld(mesh, share * scale);
      ASSERT_TRUE(welded) << welded.error().text;
      expect_promises(mesh, *welded, share * scale);
    }
  }
}

TEST(Weld, TolerancesAsSmallAsTheSpacingOfDoubles) {
  // Numbers of cells on both sides of 2^53 and -2^53, where one and the next cannot be told apart.
  test::Random random(4);
  for (const double sign : {1.0, -1.0}) {
    Mesh mesh;
    mesh.vertices = {{0, 0, 0}, {0, 100, 0}};
    for (std::uint32_t i = 0; i < 300; ++i) {
      const auto steps = static_cast<double>(random.below(9)) - 4;
      const double ulp = steps < 0 ? 0x1p-46 : 0x1p-45;
      mesh.vertices.push_back(
          {sign * (128 + steps * ulp), sign * (128 - steps * 0x1p-45), static_cast<double>(random.below(4))});
      mesh.triangles.push_back({0, 1, 2 + i});
    }
    for (const double tolerance : {0x1p-46, 0x1.8p-46, 0x1p-45, 0x1p-44}) {
      expect_promises(mesh, weld(mesh, tolerance).value(), tolerance);
    }
  }
}

TEST(Weld, EverythingAtOnePointIsAnError) {
  Mesh mesh;
  mesh.vertices.assign(3000, {1, 2, 3});
  for (std::uint32_t i = 0; i < 3000; i += 3) mesh.triangles.push_back({i, i + 1, i + 2});
  EXPECT_EQ(weld(mesh, 0).error().code, Code::empty_mesh);
  EXPECT_EQ(weld(mesh, 1e-9).error().code, Code::bad_option);
}

TEST(Weld, ManyVerticesWithinTheToleranceStayCheap) {
  test::Random random(6);
  Mesh mesh;
  mesh.vertices = {{1, 0, 0}, {0, 1, 0}};
  for (std::uint32_t i = 0; i < 100000; ++i) {
    mesh.vertices.push_back(random.in({{0, 0, 0}, {1e-3, 1e-3, 1e-3}}));
    mesh.triangles.push_back({0, 1, 2 + i});
  }
  // Comparing all pairs would take minutes.
  const Welded welded = weld(mesh, 0.002).value();
  EXPECT_EQ(welded.mesh.vertices.size(), 3U);
  EXPECT_EQ(welded.report.merged_vertices, 99999U);
  EXPECT_EQ(welded.report.collapsed_triangles, 0U);
}

TEST(Weld, CanBeCancelled) {
  cdfr::Run run;
  run.tick = [](void*, double) noexcept { return false; };
  EXPECT_EQ(weld(cube(), 0.001, run).error().code, Code::cancelled);
}

TEST(Weld, ThePublicCrackedPartCloses) {
  const auto path = std::filesystem::path(CDFR_SHARED_DATA) / "public/dirty_pub/nist1_crack_jitter.stl";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no shared data at " << path;
  const Mesh mesh = read_mesh(path).value();
  EXPECT_EQ(audit(mesh.view())->open_edges, 5784U);
  EXPECT_EQ(audit(weld(mesh, 0)->mesh.view())->open_edges, 5784U);
  const Welded welded = weld(mesh, 0.01).value();
  const MeshReport report = audit(welded.mesh.view()).value();
  EXPECT_TRUE(report.closed());
  EXPECT_EQ(report.vertices, 944U);
  EXPECT_EQ(welded.mesh.triangles.size() + welded.report.collapsed_triangles, 1928U);
}

}  // namespace
}  // namespace cdfr
