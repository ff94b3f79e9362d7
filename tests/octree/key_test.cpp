#include "octree/key.h"

#include <gtest/gtest.h>

#include "support/random.h"

namespace cdfr {
namespace {

Cell random_cell(test::Random& random) {
  Cell cell;
  const auto levels = static_cast<int>(random.below(deepest_level + virtual_levels + 1));
  for (int i = 0; i < levels; ++i) cell = child_of(cell, static_cast<int>(random.below(8)));
  return cell;
}

TEST(Key, RoundTripsDownToTheDeepestLevel) {
  test::Random random(1);
  for (int i = 0; i < 10000; ++i) {
    const Cell cell = random_cell(random);
    EXPECT_EQ(cell_of(key_of(cell)), cell);
  }
  Cell deepest;
  while (deepest.level < deepest_level) deepest = child_of(deepest, 7);
  EXPECT_EQ(cell_of(key_of(deepest)), deepest);
  EXPECT_EQ(key_of(Cell{}), 1U);
}

TEST(Key, ChildrenFollowTheirParentInMortonOrder) {
  test::Random random(2);
  for (int i = 0; i < 1000; ++i) {
    const Cell cell = random_cell(random);
    if (cell.level == deepest_level) continue;
    for (int child = 0; child < 8; ++child) {
      EXPECT_EQ(key_of(child_of(cell, child)), key_of(cell) << 3 | static_cast<unsigned>(child));
    }
  }
}

}  // namespace
}  // namespace cdfr
