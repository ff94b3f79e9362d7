// The paper's extraction keeps just the sub-voxels that a plain evaluation of the octree's distance keeps.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "cdfr/field/field.h"
#include "cdfr/reference/uniform.h"
#include "cdfr/reference/uniform_contour.h"
#include "reference/grid.h"
#include "reference/models.h"
#include "reference/uniform_data.h"
#include "support/same.h"

namespace cdfr {
namespace {

using test::ReferenceModel;

/// Three sub-voxels along a voxel's edge, as few as the paper's rule allows for this tolerance.
constexpr int along = 3;
double tolerance_for(const VoxelGrid& grid) { return 1.01 * half_diagonal_of_unit * grid.size / along; }

using Position = std::array<double, 3>;
Position position_of(const Vec3& x) { return {x.x, x.y, x.z}; }

/// Centres of all sub-voxels of the grid.
std::vector<Vec3> all_centres(const VoxelGrid& grid) {
  std::vector<Vec3> centres;
  const auto coordinate = [](int i) { return (i + 0.5) / along; };
  for (int z = 0; z < along * grid.counts[2]; ++z) {
    for (int y = 0; y < along * grid.counts[1]; ++y) {
      for (int x = 0; x < along * grid.counts[0]; ++x) {
        centres.push_back(grid.at(coordinate(x), coordinate(y), coordinate(z)));
      }
    }
  }
  return centres;
}

class SubVoxels : public testing::TestWithParam<ReferenceModel> {
 protected:
  void SetUp() override {
    std::string reason = test::reason_to_skip(GetParam());
    if (!GetParam().closed) reason = "an open mesh has no inside";
    if (!reason.empty()) GTEST_SKIP() << reason;
    const Mesh mesh = test::mesh_of(GetParam());
    BuildOptions build;
    build.max_level = 4;
    field_.emplace(Field::build(mesh.view(), build).value());
    UniformOptions options;
    options.resolution = GetParam().resolution;
    uniform_.emplace(UniformField::build(mesh.view(), options).value());
    centres_ = all_centres(grid());
    distances_.resize(centres_.size());
    field_->distance(Points(std::span<const Vec3>(centres_)), distances_).value();
  }

  const VoxelGrid& grid() const { return uniform_->data().grid; }

  std::optional<Field> field_;
  std::optional<UniformField> uniform_;
  std::vector<Vec3> centres_;
  std::vector<double> distances_;
};

TEST_P(SubVoxels, are_kept_by_octree_and_uniform_field_alike) {
  UniformContourOptions options;
  options.tolerance = tolerance_for(grid());
  std::size_t plain = 0, ghosts = 0;
  for (const double voxels : {0.3, 1.0, 1.7}) {
    const double depth = voxels * grid().size;
    std::map<Position, ContourPoint> kept;
    const auto points = contour_points(*uniform_, depth, options).value();
    for (const ContourPoint& p : points) {
      ASSERT_TRUE(kept.emplace(position_of(p.position), p).second) << "twice";
    }
    for (std::size_t i = 0; i < centres_.size(); ++i) {
      if (!(std::fabs(-distances_[i] - depth) <= options.tolerance / 2)) continue;
      ++plain;
      const auto at = kept.find(position_of(centres_[i]));
      ASSERT_NE(at, kept.end()) << "lost at depth " << depth;
      const UniformClosest found = uniform_->closest(centres_[i]);
      ASSERT_TRUE(test::same_bits(found.distance, distances_[i]));
      ASSERT_EQ(at->second.triangle, found.base);
      ASSERT_EQ(std::isfinite(at->second.error), -found.distance >= depth);
      kept.erase(at);
    }
    // What is left is there by the paper's sign rule alone: outside, and closest to a vertex.
    for (const auto& [position, p] : kept) {
      const UniformClosest found = uniform_->closest(p.position);
      ASSERT_EQ(found.feature, Feature::vertex);
      ASSERT_TRUE(test::same_bits(-found.distance, field_->distance(p.position)));
      ++ghosts;
    }
  }
  EXPECT_GT(plain, 200U);
  EXPECT_EQ(ghosts > 0, GetParam().part == "tetrahedron") << ghosts;
  RecordProperty("kept", static_cast<int>(plain));
  RecordProperty("ghosts", static_cast<int>(ghosts));
}

/// The report's spaces between voxel centres lose what its corner test does not see, and nothing else: with
/// four sub-voxels both lie on one lattice.
TEST_P(SubVoxels, of_the_report_are_some_of_the_papers) {
  const double depth = 0.3 * grid().size;
  UniformContourOptions options;
  options.tolerance = 1.01 * half_diagonal_of_unit * grid().size / 2;
  std::map<Position, ContourPoint> paper;
  const auto points = contour_points(*uniform_, depth, options).value();
  for (const ContourPoint& p : points) paper.emplace(position_of(p.position), p);
  options.regions = UniformRegions::inter_voxel;
  const auto report = contour_points(*uniform_, depth, options).value();
  for (const ContourPoint& p : report) {
    const auto at = paper.find(position_of(p.position));
    ASSERT_NE(at, paper.end());
    ASSERT_TRUE(test::same_bits(at->second.error, p.error));
  }
  EXPECT_GT(paper.size(), 0U);
  EXPECT_LE(report.size(), paper.size());
  RecordProperty("paper", static_cast<int>(paper.size()));
  RecordProperty("report", static_cast<int>(report.size()));
}

INSTANTIATE_TEST_SUITE_P(Models, SubVoxels, testing::ValuesIn(test::reference_models()),
                         [](const auto& instance) { return instance.param.name; });

}  // namespace
}  // namespace cdfr
