// The counts of the paper's tables 2 and 3, beside those of its method as it is written.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "cdfr/parts/part.h"
#include "cdfr/reference/uniform.h"

namespace cdfr {
namespace {

/// A row of papers/huang-2001/table-2.csv or table-3.csv; voxels in thousands.
struct Row {
  std::string part;
  int resolution = 32;
  std::array<int, 3> counts{};
  double inside = 0, surface = 0, outside = 0, surface_mean = 0, inside_mean = 0;
};

const std::vector<Row> rows{{"cube", 32, {32, 32, 32}, 9.2, 5.7, 17.8, 1.29, 2.47},
                            {"tetrahedron", 32, {32, 32, 32}, 1.0, 2.3, 29.5, 1.14, 2.19},
                            {"one-tooth", 32, {20, 32, 32}, 2.6, 3.7, 14.2, 1.45, 2.58},
                            {"six-star", 32, {15, 29, 32}, 0.5, 2.1, 11.3, 2.17, 4.30},
                            {"cube", 64, {64, 64, 64}, 148.9, 29.4, 83.8, 1.13, 2.23},
                            {"tetrahedron", 64, {64, 64, 64}, 20.8, 10.6, 230.7, 1.06, 2.07},
                            {"one-tooth", 64, {36, 64, 64}, 50.0, 18.5, 80.0, 1.20, 2.27},
                            {"six-star", 64, {28, 61, 64}, 13.8, 9.8, 62.4, 1.49, 2.88}};

UniformField field_of(const Row& row, UniformVoxels voxels, bool surface_inherits) {
  UniformOptions options;
  options.border = 4;  // the paper's resolutions count eight empty voxels along each axis
  options.resolution = row.resolution - 2 * options.border;
  options.surface_inherits = surface_inherits;
  options.voxels = voxels;
  return UniformField::build(make_part(row.part).value().view(), options).value();
}

double surface_mean(const UniformStats& stats) {
  return static_cast<double>(stats.surface_tuples) / static_cast<double>(stats.surface_cells);
}
double inside_mean(const UniformStats& stats) {
  return static_cast<double>(stats.inside_tuples) / static_cast<double>(stats.inside_cells);
}

class PaperTables : public testing::TestWithParam<Row> {};

/// The text lets surface voxels inherit; the tables' means are those of surface voxels that do not.
TEST_P(PaperTables, surface_means_are_those_of_touching_triangles) {
  const Row& row = GetParam();
  const UniformField touching = field_of(row, UniformVoxels::cells, false);
  const UniformStats touches = touching.stats(), inherits = field_of(row, UniformVoxels::cells, true).stats();
  // Table 3 has the six-star in other proportions than its part (README).
  const bool in_proportion = row.part != "six-star" || row.resolution == 32;
  EXPECT_EQ(touching.counts() == row.counts, in_proportion);
  EXPECT_EQ(touches.surface_cells, inherits.surface_cells);
  const double off_touching = std::fabs(surface_mean(touches) - row.surface_mean);
  const double off_inheriting = std::fabs(surface_mean(inherits) - row.surface_mean);
  EXPECT_LT(off_touching, off_inheriting);
  EXPECT_LT(off_touching, 0.26);
  EXPECT_LT(surface_mean(touches), 2);
}

/// Voxels as points of the lattice: the counts of inner voxels are the paper's to 1 % where the part is a
/// cube or a tetrahedron, but for a printed 1.0 that is 969. What is not within 15 % of the paper is named in
/// papers/huang-2001/README.md.
TEST_P(PaperTables, inner_voxels_are_points_deeper_than_a_voxel) {
  const Row& row = GetParam();
  const UniformField field = field_of(row, UniformVoxels::points, false);
  const UniformStats stats = field.stats();
  const bool star = row.part == "six-star";
  const auto off = [](double got, double wanted) { return std::fabs(got / wanted - 1); };
  const double inside = static_cast<double>(stats.inside_cells) / 1000;
  const double outside = static_cast<double>(stats.outside_cells) / 1000;
  const double surface = static_cast<double>(stats.surface_cells) / 1000;
  EXPECT_LT(off(inside, row.inside), star ? 0.31 : row.part == "one-tooth" ? 0.036 : 0.032);
  EXPECT_LT(off(outside, row.outside), 0.15);
  EXPECT_LT(off(surface, row.surface), star ? 0.56 : row.part == "cube" ? 0.24 : 0.151);
  EXPECT_LT(off(surface_mean(stats), row.surface_mean), star ? 0.18 : 0.13);
  EXPECT_EQ(stats.inside_cells + stats.surface_cells + stats.outside_cells, field.cell_count());
}

/// Closed forms: of a cube n voxels long (n - 3)^3 points are more than a voxel deep, of a tetrahedron at the
/// origin those from 2 on whose coordinates add up to n - 2 at most: its slanting side is 2 / sqrt(3) away
/// from them.
TEST(PaperVoxels, InnerPointsOfCubeAndTetrahedron) {
  for (const std::uint64_t n : {24U, 56U}) {
    const auto inside = [&](const char* part) {
      UniformOptions options;
      options.resolution = static_cast<int>(n);
      options.border = 4;
      options.voxels = UniformVoxels::points;
      return UniformField::build(make_part(part).value().view(), options)->stats().inside_cells;
    };
    EXPECT_EQ(inside("cube"), (n - 3) * (n - 3) * (n - 3));
    EXPECT_EQ(inside("tetrahedron"), (n - 5) * (n - 6) * (n - 7) / 6);
  }
}

INSTANTIATE_TEST_SUITE_P(Rows, PaperTables, testing::ValuesIn(rows), [](const auto& instance) {
  std::string name = instance.param.part + "_" + std::to_string(instance.param.resolution);
  std::ranges::replace(name, '-', '_');
  return name;
});

/// "About twice as many" inside: the tetrahedron has 1.4 times, the six-star 4.2 times as many.
TEST(PaperTables32, InnerVoxelsHoldNotAlwaysTwiceAsManyAsSurfaceVoxels) {
  const auto ratio = [](const Row& row) {
    const UniformStats stats = field_of(row, UniformVoxels::cells, false).stats();
    return inside_mean(stats) / surface_mean(stats);
  };
  EXPECT_LT(ratio(rows[1]), 1.5);
  EXPECT_GT(ratio(rows[3]), 4);
}

}  // namespace
}  // namespace cdfr
