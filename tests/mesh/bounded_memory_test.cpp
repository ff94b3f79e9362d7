// How much anonymous memory examine() takes, as the kernel counts it.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <fstream>
#include <string>
#include <thread>

#include "cdfr/export/write.h"
#include "cdfr/parts/part.h"
#include "mesh/examine.h"
#include "mesh/large_mesh.h"
#include "support/scratch.h"

namespace cdfr {
namespace {

/// Bytes; 0 if the kernel does not tell.
std::uint64_t anonymous_memory() {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    std::uint64_t kilobytes = 0;
    if (word == "RssAnon:" && status >> kilobytes) return kilobytes * 1024;
  }
  return 0;
}

/// The most that it grows by during the work, looked at every millisecond.
template <class Work>
std::uint64_t growth_during(Work work) {
  const std::uint64_t before = anonymous_memory();
  std::atomic<bool> done = false;
  std::uint64_t peak = before;
  std::thread watch([&] {
    while (!done) {
      peak = std::max(peak, anonymous_memory());
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  });
  work();
  done = true;
  watch.join();
  return peak - before;
}

class BoundedMemory : public ScratchTest {};

TEST_F(BoundedMemory, WhatGrowsWithTheMeshLiesInTheScratch) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "a sanitizer's own memory is counted too";
#endif
  if (anonymous_memory() == 0) GTEST_SKIP() << "the kernel does not tell";
  const auto path = folder() / "heads.stl";
  ASSERT_TRUE(write_mesh(make_part("cylinder-head", 3).value().view(), path));
  const Scratch scratch(folder());
  const cdfr::Run run;
  Progress progress(run);
  const auto examined_triangles = [&](MeshView mesh, const Scratch* where) {
    return examine(mesh, progress, where).value().triangles.size();
  };
  LargeMesh mesh;
  std::uint32_t triangles = 0;
  const std::uint64_t in_scratch = growth_during([&] {
    mesh = read_large_mesh(path, scratch, false, progress).value();
    triangles = examined_triangles(mesh.view(), &scratch);
  });
  const std::uint64_t on_heap = growth_during([&] { (void)examined_triangles(mesh.view(), nullptr); });
  EXPECT_GT(on_heap, 200 * std::uint64_t{triangles});  // or nothing was measured
  EXPECT_LT(in_scratch, 20 * std::uint64_t{triangles});
  EXPECT_LT(in_scratch, on_heap / 8);
}

}  // namespace
}  // namespace cdfr
