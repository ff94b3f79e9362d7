// A build that shares a frontier between workers crashes with two of them once the start level is deep, or
// lets the order of arrival into the result.
#include <gtest/gtest.h>

#include "cdfr/field/field.h"
#include "faults/star.h"
#include "support/meshes.h"
#include "support/same.h"

namespace cdfr {
namespace {

Field built(const Mesh& mesh, int max_level, double gain, unsigned threads) {
  BuildOptions options;
  options.max_triangles_per_leaf = 8;
  options.max_level = max_level;
  options.gain = gain;
  Run run;
  run.threads = threads;
  return Field::build(mesh.view(), options, run).value();
}

TEST(ThreadedBuild, IsTheSameForAnyNumberOfThreadsAtAnyDepth) {
  const Mesh mesh = test::spiky_star(2, 1);
  for (const int level : {0, 1, 3, 6}) {
    const Field alone = built(mesh, level, 0.75, 1);
    for (const unsigned threads : {2U, 3U, 8U, 2U, 2U}) {
      const Field field = built(mesh, level, 0.75, threads);
      EXPECT_EQ(field.checksum(), alone.checksum()) << level << ' ' << threads;
      EXPECT_EQ(field.leaf_count(), alone.leaf_count());
    }
  }
}

/// With the gain test off every long leaf goes down to the last level: many cells wait for two workers.
TEST(ThreadedBuild, SurvivesTwoThreadsWhereEveryCellSplits) {
  const Mesh mesh = test::sphere_mesh(2);
  for (const int level : {2, 4}) {
    const Field alone = built(mesh, level, 1, 1);
    for (const unsigned threads : {2U, 4U}) {
      EXPECT_EQ(built(mesh, level, 1, threads).checksum(), alone.checksum());
    }
  }
}

TEST(ThreadedBuild, AnswersDoNotDependOnDepthOrThreads) {
  const Mesh mesh = test::spiky_star(2, 2);
  const BruteForce brute = BruteForce::over(mesh.view()).value();
  for (const int level : {0, 2, 5}) {
    for (const unsigned threads : {1U, 2U, 5U}) {
      const Field field = built(mesh, level, 0.75, threads);
      test::Random random(3);
      for (int i = 0; i < 300; ++i) {
        const Vec3 p = random.in({{-1500, -1500, -1500}, {1500, 1500, 1500}});
        ASSERT_TRUE(test::same_bits(field.closest(p), brute.closest(p))) << level << ' ' << threads;
      }
    }
  }
}

}  // namespace
}  // namespace cdfr
