// Sheets that are nearer to each other than a cell, a voxel or a float: grids fuse them, flood fills leak
// through them, and a normal of the wrong sheet turns the sign.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>

#include "cdfr/field/field.h"
#include "faults/block_solid.h"
#include "faults/promise.h"

namespace cdfr {
namespace {

const test::Planes unit{0, 1};

void expect_trusted_and_right(const test::BlockSolid& solid, std::uint64_t seed) {
  for (const int level : {0, 4}) {
    BuildOptions options;
    options.max_level = level;
    options.max_triangles_per_leaf = 8;
    const Field field = Field::build(solid.mesh().view(), options).value();
    EXPECT_TRUE(field.report().embedded()) << sign_reason(field.report());
    EXPECT_EQ(field.sign(), Sign::pseudonormal);
    test::expect_right(field, solid, 3000, seed);
  }
}

TEST(CloseSheets, TwoPlatesWithAGapBetweenThem) {
  for (const double gap : {1e-3, 1e-9, 0x1p-52}) {
    const test::BlockSolid plates(unit, unit, {0, 1, 1 + gap, 2}, [](int, int, int k) { return k != 1; });
    expect_trusted_and_right(plates, 1);
    const Field field = Field::build(plates.mesh().view()).value();
    EXPECT_EQ(field.distance({0.5, 0.5, 0.9}), -(1 - 0.9));
    if (gap > 0x1p-50) {
      EXPECT_GT(field.distance({0.5, 0.5, 1 + gap / 2}), 0);
    }
  }
}

TEST(CloseSheets, APlateAsThinAsAnUlp) {
  for (const double thickness : {1e-6, 1e-9, 0x1p-51}) {
    const test::BlockSolid plate(unit, unit, {1, 1 + thickness}, [](int, int, int) { return true; });
    expect_trusted_and_right(plate, 2);
    const Field field = Field::build(plate.mesh().view()).value();
    EXPECT_LT(field.distance({0.5, 0.5, 1 + thickness / 2}), 0);
    EXPECT_GT(field.distance({0.5, 0.5, 1 + 2 * thickness}), 0);
    EXPECT_GT(field.distance({0.5, 0.5, 1 - thickness}), 0);
  }
}

/// Full, hollow, full and hollow from the outside in, each shell next to the one before.
TEST(CloseSheets, NestedShellsAndCavities) {
  for (const double gap : {1e-3, 1e-9}) {
    const test::Planes planes{0, gap, 2 * gap, 3 * gap, 1, 1 + gap, 1 + 2 * gap, 1 + 3 * gap};
    const test::BlockSolid shells(planes, planes, planes, [](int i, int j, int k) {
      const auto depth = [](int at) { return std::min(at, 6 - at); };
      return std::min({depth(i), depth(j), depth(k)}) % 2 == 0;
    });
    const Field field = Field::build(shells.mesh().view()).value();
    EXPECT_EQ(field.report().components, 4U);
    expect_trusted_and_right(shells, 3);
    EXPECT_GT(field.distance({0.5, 0.5, 0.5}), 0);
    EXPECT_LT(field.distance({0.5, 0.5, 2.5 * gap}), 0);
    EXPECT_GT(field.distance({0.5, 0.5, 1.5 * gap}), 0);
    EXPECT_LT(field.distance({0.5, 0.5, 0.5 * gap}), 0);
  }
}

TEST(CloseSheets, ACavityJustUnderTheSkin) {
  const test::BlockSolid bubble({0, 0.4, 0.6, 1}, {0, 0.4, 0.6, 1}, {0, 0.5, 1 - 1e-9, 1},
                                [](int i, int j, int k) { return i != 1 || j != 1 || k != 1; });
  expect_trusted_and_right(bubble, 4);
  const Field field = Field::build(bubble.mesh().view()).value();
  EXPECT_LT(field.distance({0.5, 0.5, 1 - 0.5e-9}), 0);
  EXPECT_GT(field.distance({0.5, 0.5, 1 - 2e-9}), 0);
}

/// The walls of a slot all but touch, far below the size of any cell.
TEST(CloseSheets, ASlotThatAlmostCloses) {
  const test::BlockSolid slot({0, 0.5, 0.5 + 1e-9, 1}, {0, 0.2, 1}, unit,
                              [](int i, int j, int) { return i != 1 || j == 0; });
  expect_trusted_and_right(slot, 5);
}

}  // namespace
}  // namespace cdfr
