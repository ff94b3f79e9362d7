// One byte for kind and count (papers/huang-2001, section 5.3) says two things of one voxel from 128
// triangles on.
#include "reference/count_byte.h"

#include <gtest/gtest.h>

#include "cdfr/reference/uniform.h"
#include "support/meshes.h"

namespace cdfr {
namespace {

TEST(CountByte, HoldsUpTo127OnTheSurfaceAnd128Inside) {
  for (std::size_t n = 1; n <= 127; ++n) {
    const CountByte voxel = decode_count_byte(encode_count_byte({Side::surface, n}));
    EXPECT_EQ(voxel.side, Side::surface);
    EXPECT_EQ(voxel.count, n);
  }
  for (std::size_t n = 1; n <= 128; ++n) {
    const CountByte voxel = decode_count_byte(encode_count_byte({Side::inside, n}));
    EXPECT_EQ(voxel.side, Side::inside);
    EXPECT_EQ(voxel.count, n);
  }
  EXPECT_EQ(decode_count_byte(encode_count_byte({})).side, Side::outside);
}

TEST(CountByte, TakesASurfaceVoxelOf200ForAnInnerOneOf73) {
  EXPECT_EQ(encode_count_byte({Side::surface, 200}), encode_count_byte({Side::inside, 73}));
  EXPECT_EQ(encode_count_byte({Side::inside, 129}), encode_count_byte({Side::outside, 0}));
  EXPECT_EQ(encode_count_byte({Side::inside, 130}), encode_count_byte({Side::surface, 1}));
}

/// A sphere is enough for it: voxels whose list the byte turns into another kind or another count.
TEST(CountByte, LosesVoxelsOfASphere) {
  UniformOptions options;
  options.resolution = 7;
  const UniformField sphere = UniformField::build(test::sphere_mesh(4).view(), options).value();
  std::size_t another_side = 0, another_count = 0, kept = 0;
  for (std::size_t cell = 0; cell < sphere.cell_count(); ++cell) {
    const CountByte voxel{sphere.side(cell), sphere.list(cell).size()};
    if (voxel.side == Side::outside) continue;
    const CountByte read = decode_count_byte(encode_count_byte(voxel));
    if (read.side != voxel.side) {
      ++another_side;
    } else if (read.count != voxel.count) {
      ++another_count;
    } else {
      ++kept;
    }
  }
  EXPECT_GT(another_side, 0U);
  EXPECT_GT(another_count, 0U);
  RecordProperty("another_side", static_cast<int>(another_side));
  RecordProperty("another_count", static_cast<int>(another_count));
  RecordProperty("kept", static_cast<int>(kept));
  const auto centre = sphere.locate({0.01, 0.01, 0.01});
  ASSERT_TRUE(centre);
  EXPECT_EQ(sphere.list(*centre).size(), 2048U);
  EXPECT_EQ(decode_count_byte(encode_count_byte({Side::inside, 2048})).count, 127U);
  EXPECT_EQ(decode_count_byte(encode_count_byte({Side::inside, 2048})).side, Side::surface);
}

}  // namespace
}  // namespace cdfr
