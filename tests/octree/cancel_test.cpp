// A build that is cancelled at any moment ends, on any number of threads.
#include <gtest/gtest.h>

#include <atomic>

#include "cdfr/field/field.h"
#include "support/meshes.h"

namespace cdfr {
namespace {

TEST(CancelledBuild, EndsByNameAtAnyTick) {
  const Mesh mesh = test::sphere_mesh(4);
  BuildOptions options;
  options.max_triangles_per_leaf = 4;
  int cancelled = 0;
  for (int ticks = 1; ticks < 4000; ticks += 1 + ticks / 3) {
    std::atomic<int> left = ticks;
    cdfr::Run run;
    run.threads = 2;
    run.context = &left;
    run.tick = [](void* context, double) noexcept { return --*static_cast<std::atomic<int>*>(context) > 0; };
    const Result<Field> field = Field::build(mesh.view(), options, run);
    if (field) break;
    EXPECT_EQ(field.error().code, Code::cancelled);
    ++cancelled;
  }
  EXPECT_GT(cancelled, 5);
}

}  // namespace
}  // namespace cdfr
