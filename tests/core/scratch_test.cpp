#include "core/scratch.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <fstream>
#include <new>
#include <numeric>
#include <sstream>
#include <string>
#include <utility>

#include "support/scratch.h"

namespace cdfr {
namespace {

/// What the kernel says of the map that begins at that address; empty if none does.
std::string map_at(const void* address) {
  std::ifstream maps("/proc/self/maps");
  for (std::string line; std::getline(maps, line);) {
    std::uintptr_t first = 0;
    std::istringstream(line) >> std::hex >> first;
    if (first == reinterpret_cast<std::uintptr_t>(address)) return line;
  }
  return {};
}

class ScratchFiles : public ScratchTest {};

TEST_F(ScratchFiles, LargeBlocksAreMapsOfFilesWithoutAName) {
  const Scratch scratch(folder());
  const std::size_t bytes = 3 * Scratch::large + 5;
  auto* block = static_cast<unsigned char*>(scratch.allocate(bytes));
  EXPECT_NE(map_at(block).find(folder().string()), std::string::npos) << map_at(block);
  EXPECT_EQ(names(), std::vector<std::string>());
  EXPECT_EQ(block[0] + block[bytes - 1], 0);
  std::memset(block, 0xa5, bytes);
  EXPECT_EQ(block[bytes - 1], 0xa5);
  scratch.release(block, bytes);
  EXPECT_EQ(map_at(block), "");
}

TEST_F(ScratchFiles, SmallBlocksComeFromTheHeap) {
  const Scratch scratch(folder());
  void* small = scratch.allocate(Scratch::large - 1);
  void* large = scratch.allocate(Scratch::large);
  EXPECT_EQ(map_at(small).find(folder().string()), std::string::npos);
  EXPECT_NE(map_at(large).find(folder().string()), std::string::npos);
  std::memset(small, 1, Scratch::large - 1);
  scratch.release(small, Scratch::large - 1);
  scratch.release(large, Scratch::large);
}

TEST_F(ScratchFiles, WhatCannotBeHadIsABadAllocation) {
  const Scratch missing(folder() / "missing");
  EXPECT_THROW(missing.allocate(Scratch::large), std::bad_alloc);
  EXPECT_THROW(Large<double>(Scratch::large, &missing), std::bad_alloc);
  EXPECT_EQ(Large<double>(3, &missing).size(), 3U);  // small
  const Scratch scratch(folder());
  EXPECT_THROW(scratch.allocate(std::size_t{1} << 62), std::bad_alloc);  // more than any disk
  EXPECT_THROW(scratch.allocate(static_cast<std::size_t>(-1)), std::bad_alloc);
  Large<double> values(&scratch);
  EXPECT_THROW(values.get_allocator().allocate(static_cast<std::size_t>(-1) / 4), std::bad_alloc);
  EXPECT_EQ(names(), std::vector<std::string>());
}

TEST_F(ScratchFiles, AVectorGrowsFromHeapToFile) {
  const Scratch scratch(folder());
  Large<std::uint64_t> values(&scratch);
  for (std::uint64_t i = 0; i < 300000; ++i) values.push_back(i);
  EXPECT_NE(map_at(values.data()).find(folder().string()), std::string::npos);
  EXPECT_EQ(std::accumulate(values.begin(), values.end(), std::uint64_t{0}), 300000ULL * 299999 / 2);
}

TEST_F(ScratchFiles, MovesCopiesAndSwapsKeepTheirScratch) {
  const Scratch scratch(folder());
  Large<std::uint32_t> in_file(Scratch::large, 7, &scratch);
  const std::uint32_t* data = in_file.data();

  Large<std::uint32_t> moved = std::move(in_file);
  EXPECT_EQ(moved.data(), data);
  EXPECT_EQ(moved.get_allocator().scratch(), &scratch);

  Large<std::uint32_t> assigned;
  assigned.assign(5, 1);
  assigned = std::move(moved);
  EXPECT_EQ(assigned.data(), data);
  EXPECT_EQ(assigned.get_allocator().scratch(), &scratch);

  const Large<std::uint32_t> copy = assigned;
  EXPECT_EQ(copy, assigned);
  EXPECT_EQ(copy.get_allocator().scratch(), &scratch);

  Large<std::uint32_t> on_heap(3, 9);
  swap(on_heap, assigned);
  EXPECT_EQ(on_heap.data(), data);
  EXPECT_EQ(assigned, Large<std::uint32_t>(3, 9));
  EXPECT_EQ(assigned.get_allocator().scratch(), nullptr);
}

}  // namespace
}  // namespace cdfr
