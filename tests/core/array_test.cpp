#include "core/array.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <numeric>
#include <span>
#include <vector>

#include "core/scratch.h"
#include "support/scratch.h"

namespace cdfr {
namespace {

TEST(Array, ByDefaultIsEmpty) {
  Array<int> none;
  EXPECT_TRUE(none.empty());
  EXPECT_EQ(none.begin(), none.end());
  EXPECT_EQ(none.bytes(), 0U);
  EXPECT_TRUE(none.edit().empty());
}

TEST(Array, TakesOverAVectorWithoutACopy) {
  std::vector<std::uint16_t> values{3, 1, 4, 1, 5};
  const std::uint16_t* data = values.data();
  Array<std::uint16_t> array = std::move(values);
  EXPECT_EQ(array.data(), data);
  EXPECT_EQ(array.size(), 5U);
  EXPECT_EQ(array.bytes(), 10U);
  EXPECT_EQ(array.front(), 3);
  EXPECT_EQ(array.back(), 5);
  array.edit()[1] = 9;
  EXPECT_EQ(array[1], 9);
  EXPECT_EQ(std::accumulate(array.begin(), array.end(), 0), 22);
}

TEST(Array, CopiesShareTheValuesAndKeepThem) {
  Array<int> copy;
  {
    Array<int> array = std::vector<int>(1000, 7);
    copy = array;
    EXPECT_EQ(copy.data(), array.data());
  }
  EXPECT_EQ(std::accumulate(copy.begin(), copy.end(), 0), 7000);
}

TEST(Array, ViewsWhatAnOwnerKeeps) {
  auto owner = std::make_shared<const std::vector<int>>(std::vector<int>{1, 2, 3});
  const std::weak_ptr<const std::vector<int>> watch = owner;
  Array<int> view(owner->data(), owner->size(), owner);
  owner.reset();
  EXPECT_FALSE(watch.expired());
  EXPECT_EQ(view.back(), 3);
  view = {};
  EXPECT_TRUE(watch.expired());
}

class ArrayInScratch : public ScratchTest {};

TEST_F(ArrayInScratch, TakesOverALargeVector) {
  const Scratch scratch(folder());
  Large<std::uint64_t> values(Scratch::large, 3, &scratch);
  const std::uint64_t* data = values.data();
  Array<std::uint64_t> array = std::move(values);
  EXPECT_EQ(array.data(), data);
  array.edit().back() = 4;
  EXPECT_EQ(array.back(), 4U);
}

}  // namespace
}  // namespace cdfr
