#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "cdfr/field/field.h"
#include "cdfr/parts/part.h"
#include "support/meshes.h"
#include "support/same.h"

namespace cdfr {
namespace {

std::vector<double> distances(const Field& field, const Grid& grid, unsigned threads = 0) {
  std::vector<double> out(grid.count(), -7);
  cdfr::Run run;
  run.threads = threads;
  EXPECT_TRUE(field.distance(grid, out, run));
  return out;
}

void expect_single_answers(const Field& field, const Grid& grid) {
  const std::vector<double> out = distances(field, grid);
  std::size_t at = 0;
  for (std::uint32_t k = 0; k < grid.size[2]; ++k) {
    for (std::uint32_t j = 0; j < grid.size[1]; ++j) {
      for (std::uint32_t i = 0; i < grid.size[0]; ++i, ++at) {
        const double expected = field.distance(grid.point(i, j, k));
        ASSERT_TRUE(test::same_bits(out[at], expected)) << i << " " << j << " " << k << ": " << expected;
      }
    }
  }
}

/// A grid over the box grown by `beyond` of its sides.
Grid grid_over(const Box& box, const std::array<std::uint32_t, 3>& size, double beyond) {
  const auto lo = [&](double a, double b) { return a - beyond * (b - a); };
  const auto step = [&](double a, double b, std::uint32_t n) { return (1 + 2 * beyond) * (b - a) / (n - 1); };
  return {{lo(box.lo.x, box.hi.x), lo(box.lo.y, box.hi.y), lo(box.lo.z, box.hi.z)},
          {step(box.lo.x, box.hi.x, size[0]), step(box.lo.y, box.hi.y, size[1]),
           step(box.lo.z, box.hi.z, size[2])},
          size};
}

Field built(const Mesh& mesh) { return Field::build(mesh.view()).value(); }

TEST(Grid, EqualsSingleQueriesOnMadeParts) {
  for (const std::string_view name : {"cube", "tetrahedron", "one-tooth", "six-star"}) {
    const Field field = built(make_part(name).value());
    expect_single_answers(field, grid_over(field.bounds(), {33, 26, 21}, 0));
    expect_single_answers(field, grid_over(field.bounds(), {24, 17, 31}, 0.3));
  }
}

TEST(Grid, EqualsSingleQueriesOnFineMeshes) {
  const Field sphere = built(test::sphere_mesh(4));
  expect_single_answers(sphere, grid_over(sphere.bounds(), {41, 40, 39}, 0.02));
  const Field far = built(test::sphere_mesh(3, 0.01, {1000, -2000, 3000}));
  expect_single_answers(far, grid_over(far.bounds(), {31, 32, 33}, 0.1));
}

TEST(Grid, EqualsSingleQueriesOnAnOpenMeshWithSliversAndFlatTriangles) {
  Mesh mesh = test::soup(60, {{0, 0, 0}, {1, 1, 1}}, 8);
  mesh.triangles.push_back({0, 4, 0});
  mesh.triangles.push_back({7, 7, 7});
  mesh.vertices.push_back({0.3, 0.5, 0.1});
  mesh.vertices.push_back({0.9, 0.5, 0.1});
  mesh.vertices.push_back({0.6, 0.5 + 1e-13, 0.1});
  const auto last = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.triangles.push_back({last - 3, last - 2, last - 1});
  const Field field = built(mesh);
  expect_single_answers(field, grid_over(field.bounds(), {36, 35, 34}, 0.1));
}

/// Samples on vertices, edges and faces, where the distance is zero.
TEST(Grid, EqualsSingleQueriesOnTheSurface) {
  const Field field = built(test::box_mesh({{0, 0, 0}, {1, 1, 1}}));
  expect_single_answers(field, {{-0.25, -0.25, -0.25}, {0.0625, 0.0625, 0.0625}, {25, 25, 25}});
}

TEST(Grid, TakesAnyShapeAndPlace) {
  const Field field = built(test::sphere_mesh(3));
  for (const Grid& grid : {
           Grid{{-1, -1, 0.1}, {0.02, 0.03, 1}, {101, 67, 1}},
           Grid{{0.2, -1, -1}, {1, 0.02, 0.02}, {1, 101, 101}},
           Grid{{-1, 0.3, 0.3}, {0.001, 1, 1}, {2001, 1, 1}},
           Grid{{0.1, -1, -1}, {0, 0.1, 0.1}, {9, 21, 21}},
           Grid{{1, 1, 1}, {-0.05, -0.07, -0.1}, {41, 29, 21}},
           Grid{{50, 60, 70}, {1, 1, 1}, {8, 8, 8}},
           Grid{{-100, -3, -3}, {10, 0.5, 0.5}, {21, 13, 13}},
           Grid{{-1e308, 0, 0}, {1e308, 0.1, 0.1}, {4, 3, 3}},
           Grid{{0, 0, 0}, {1, 1, 1}, {5, 0, 5}},
       }) {
    expect_single_answers(field, grid);
  }
}

/// Spacings that are no round numbers: an origin moved by multiples of them would round elsewhere.
TEST(Grid, APartHasTheAnswersOfTheWhole) {
  const Field field = built(test::sphere_mesh(4));
  const Grid whole = grid_over(field.bounds(), {43, 41, 37}, 0.07);
  const std::vector<double> expected = distances(field, whole);
  Grid slab = whole;
  for (; slab.first[2] < whole.size[2]; slab.first[2] += slab.size[2]) {
    slab.size[2] = std::min(10U, whole.size[2] - slab.first[2]);
    const std::vector<double> out = distances(field, slab);
    const auto begin = expected.begin() + std::ptrdiff_t{slab.first[2]} * 43 * 41;
    EXPECT_TRUE(std::equal(out.begin(), out.end(), begin)) << slab.first[2];
  }
  const Grid box{whole.origin, whole.spacing, {11, 12, 13}, {5, 17, 3}};
  expect_single_answers(field, box);
  EXPECT_EQ(distances(field, box)[0], expected[(3 * 41 + 17) * 43 + 5]);
}

/// Thin triangles around an axis, all equally close to its samples, and close pairs of sheets.
TEST(Grid, EqualsSingleQueriesWhereManyTrianglesTie) {
  for (const std::string_view name : {"cylinder-head", "six-star"}) {
    const Field field = built(make_part(name).value());
    const Box b = field.bounds();
    expect_single_answers(field, grid_over(b, {29, 31, 30}, 0.05));
    // A plane through the middle, twice as fine along it.
    const Grid fine = grid_over(b, {97, 89, 3}, 0);
    expect_single_answers(field, {fine.origin, fine.spacing, {97, 89, 1}, {0, 0, 1}});
  }
  const Field cylinder = built(test::sphere_mesh(5, 1, {0, 0, 0}));
  // Around the centre, from which all triangles are about as far.
  expect_single_answers(cylinder, {{-0.01, -0.01, -0.01}, {0.0025, 0.0025, 0.0025}, {9, 9, 9}});
}

/// Each rounds in single precision by itself: what tiles prune must not depend on the mesh's place or size.
TEST(Grid, EqualsSingleQueriesNearLargeTrianglesAndFarFromTheOrigin) {
  Mesh mesh = test::box_mesh({{1000, 1000, 1000}, {1100, 1001, 1030}});
  const Mesh dust = test::sphere_mesh(2, 0.05, {1050, 1001.3, 1015});
  const auto shift = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), dust.vertices.begin(), dust.vertices.end());
  for (Triangle t : dust.triangles) mesh.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
  const Field field = built(mesh);
  expect_single_answers(field, grid_over(field.bounds(), {37, 33, 35}, 0.05));
  expect_single_answers(field, {{1049.9, 1001.1, 1014.9}, {0.01, 0.01, 0.01}, {25, 25, 25}});
}

TEST(Grid, OfAMeshThatIsTheOriginAlone) {
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}};
  mesh.triangles = {{0, 0, 0}};
  const Field field = built(mesh);
  for (const double spacing : {1.0, 1e-100, 1e-250, 1e-310}) {
    expect_single_answers(field, {{0, 0, 0}, {spacing, spacing, spacing}, {4, 4, 4}});
  }
}

TEST(Grid, IsNotANumberWhereACoordinateIsNotFinite) {
  const Field field = built(test::sphere_mesh(2));
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double d : distances(field, {{nan, 0, 0}, {1, 1, 1}, {3, 3, 3}})) EXPECT_TRUE(std::isnan(d));
  const auto out = distances(field, {{0, 0, 0}, {HUGE_VAL, 0.1, 0.1}, {2, 2, 2}});
  for (const double d : out) EXPECT_TRUE(std::isnan(d)) << "infinity times zero too";
}

TEST(Grid, SameForAnyThreadsAndOnEveryInstructionSet) {
  const Mesh mesh = test::sphere_mesh(4);
  const Field field = built(mesh);
  const Grid grid = grid_over(field.bounds(), {40, 40, 40}, 0.1);
  const std::vector<double> expected = distances(field, grid, 1);
  EXPECT_EQ(distances(field, grid, 2), expected);
  for (std::int64_t targets = hwy::SupportedTargets(); targets != 0; targets &= targets - 1) {
    hwy::SetSupportedTargetsForTest(targets & -targets);
    EXPECT_EQ(distances(field, grid), expected) << hwy::TargetName(targets & -targets);
  }
  hwy::SetSupportedTargetsForTest(0);
}

TEST(Grid, SameAtAnyResolutionOfTheOctree) {
  const Mesh mesh = test::sphere_mesh(3);
  const Field expected = built(mesh);
  const Grid grid = grid_over(expected.bounds(), {30, 30, 30}, 0.1);
  for (const int level : {0, 1, 2}) {
    BuildOptions options;
    options.max_level = level;
    EXPECT_EQ(distances(Field::build(mesh.view(), options).value(), grid), distances(expected, grid));
  }
}

bool stop_at_once(void*, double) noexcept { return false; }

TEST(Grid, CancelsByName) {
  const Field field = built(test::sphere_mesh(3));
  const Grid grid = grid_over(field.bounds(), {50, 50, 50}, 0);
  std::vector<double> out(grid.count());
  cdfr::Run run;
  run.tick = stop_at_once;
  const Result<void> done = field.distance(grid, out, run);
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().code, Code::cancelled);
}

bool watch(void* last, double done) noexcept {
  auto& previous = *static_cast<double*>(last);
  const bool forward = done >= previous && done <= 1;
  previous = forward ? done : 2;
  return forward;
}

TEST(Grid, ProgressNeverGoesBack) {
  const Field field = built(test::sphere_mesh(3));
  const Grid grid = grid_over(field.bounds(), {50, 50, 50}, 0);
  std::vector<double> out(grid.count());
  double last = 0;
  cdfr::Run run;
  run.tick = watch;
  run.context = &last;
  EXPECT_TRUE(field.distance(grid, out, run));
  EXPECT_EQ(last, 1);
}

}  // namespace
}  // namespace cdfr
