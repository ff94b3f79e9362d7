// Octree and uniform field are complete alike, and give the same distances to the bit.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "cdfr/field/field.h"
#include "cdfr/reference/uniform.h"
#include "reference/models.h"
#include "support/random.h"
#include "support/same.h"

namespace cdfr {
namespace {

using test::ReferenceModel;
using test::same_bits;

bool lists(std::span<const CddTuple> list, std::uint32_t triangle) {
  return std::ranges::find(list, triangle, &CddTuple::triangle) != list.end();
}

/// A point of the closed box: inside, or on faces, edges and corners.
Vec3 point_of(test::Random& random, const Box& b) {
  const auto pick = [&](double lo, double hi) {
    const auto way = random.below(8);
    return way == 0 ? lo : (way == 1 ? hi : random.between(lo, hi));
  };
  return {pick(b.lo.x, b.hi.x), pick(b.lo.y, b.hi.y), pick(b.lo.z, b.hi.z)};
}

class Agreement : public testing::TestWithParam<ReferenceModel> {
 protected:
  void SetUp() override {
    const std::string reason = test::reason_to_skip(GetParam());
    if (!reason.empty()) GTEST_SKIP() << reason;
    mesh_ = test::mesh_of(GetParam());
    BuildOptions options;
    options.max_level = 3;
    field_.emplace(Field::build(mesh_.view(), options).value());
    brute_.emplace(BruteForce::over(mesh_.view(), field_->sign()).value());
  }

  UniformField uniform(bool keep_outside) const {
    UniformOptions options;
    options.resolution = GetParam().resolution;
    options.keep_outside = keep_outside;
    return UniformField::build(mesh_.view(), options).value();
  }

  int count() const { return test::points_of(GetParam()); }

  Mesh mesh_;
  std::optional<Field> field_;
  std::optional<BruteForce> brute_;
};

/// As the paper has it, outer voxels dropped: nothing is missing for any point inside the part.
TEST_P(Agreement, inner_points_of_kept_voxels_have_their_winner) {
  if (!GetParam().closed) GTEST_SKIP() << "an open mesh has no inside";
  const UniformField uniform = this->uniform(false);
  test::Random random(11);
  int inner = 0, tried = 0;
  for (; inner < count() && tried < 60 * count(); ++tried) {
    const std::size_t cell = random.below(uniform.cell_count());
    if (uniform.side(cell) == Side::outside) continue;
    const Vec3 p = point_of(random, uniform.box(cell));
    if (!(field_->distance(p) < 0)) continue;
    ++inner;
    const Closest closest = brute_->closest(p);
    ASSERT_TRUE(lists(uniform.list(cell), closest.triangle)) << tried;
    const std::optional<std::size_t> own = uniform.locate(p);
    ASSERT_TRUE(own);
    ASSERT_FALSE(uniform.list(*own).empty()) << "an inner point in a voxel that was flooded";
    const UniformClosest found = uniform.closest(p);
    ASSERT_EQ(found.triangle, closest.triangle);
    ASSERT_TRUE(same_bits(std::fabs(found.distance), -closest.distance)) << tried;
    ASSERT_TRUE(same_bits(std::fabs(found.distance), -field_->distance(p))) << tried;
  }
  EXPECT_EQ(inner, count()) << "of " << tried;
}

/// With the outer voxels kept nothing is missing anywhere.
TEST_P(Agreement, every_point_has_its_winner_in_both) {
  const UniformField uniform = this->uniform(true);
  test::Random random(12);
  for (int i = 0; i < count(); ++i) {
    const std::size_t cell = random.below(uniform.cell_count());
    const Vec3 p = point_of(random, uniform.box(cell));
    const Closest closest = brute_->closest(p);
    ASSERT_TRUE(lists(uniform.list(cell), closest.triangle)) << i;
    ASSERT_TRUE(same_bits(closest.distance, field_->distance(p))) << i;
    const UniformClosest found = uniform.closest(p);
    if (!uniform.locate(p)) continue;  // on the grid's far border
    ASSERT_EQ(found.triangle, closest.triangle);
    ASSERT_TRUE(same_bits(std::fabs(found.distance), std::fabs(closest.distance))) << i;
  }
  for (int i = 0; i < count() / 4; ++i) {
    const Leaf leaf = field_->leaf(random.below(field_->leaf_count()));
    const Vec3 p = point_of(random, leaf.box);
    const std::uint32_t winner = brute_->closest(p).triangle;
    ASSERT_TRUE(std::ranges::binary_search(leaf.triangles, winner)) << i;
    const auto cell = uniform.locate(p);
    ASSERT_TRUE(!cell || lists(uniform.list(*cell), winner)) << i;
  }
}

TEST_P(Agreement, lists_ascend_and_keep_the_papers_range) {
  const UniformField uniform = this->uniform(false);
  for (std::size_t cell = 0; cell < uniform.cell_count(); ++cell) {
    const std::span<const CddTuple> list = uniform.list(cell);
    ASSERT_EQ(list.empty(), uniform.side(cell) == Side::outside);
    if (list.empty()) continue;
    ASSERT_TRUE(std::ranges::is_sorted(list, {},
                                       [](const CddTuple& a) { return std::pair(a.distance, a.triangle); }));
    ASSERT_LE(list.back().distance, list.front().distance + std::sqrt(3) * uniform.voxel() * (1 + 1e-9));
  }
}

INSTANTIATE_TEST_SUITE_P(Models, Agreement, testing::ValuesIn(test::reference_models()),
                         [](const auto& instance) { return instance.param.name; });

}  // namespace
}  // namespace cdfr
