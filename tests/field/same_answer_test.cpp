// Promise 3: the same field for any number of threads and on any instruction set.
#include <gtest/gtest.h>
#include <hwy/targets.h>

#include "cdfr/field/field.h"
#include "support/meshes.h"
#include "support/same.h"

namespace cdfr {
namespace {

TEST(SameAnswer, ForOneTwoAndSevenThreads) {
  for (const Mesh& mesh : {test::sphere_mesh(4), test::soup(50, {{0, 0, 0}, {1, 1, 1}}, 6)}) {
    cdfr::Run run;
    run.threads = 1;
    const std::uint64_t expected = Field::build(mesh.view(), {}, run).value().checksum();
    for (const unsigned threads : {2U, 7U}) {
      run.threads = threads;
      EXPECT_EQ(Field::build(mesh.view(), {}, run).value().checksum(), expected);
    }
  }
}

TEST(SameAnswer, OnEveryInstructionSetOfThisMachine) {
  const Mesh mesh = test::sphere_mesh(3);
  const Field expected = Field::build(mesh.view()).value();
  for (std::int64_t targets = hwy::SupportedTargets(); targets != 0; targets &= targets - 1) {
    const std::int64_t target = targets & -targets;
    hwy::SetSupportedTargetsForTest(target);
    const Field field = Field::build(mesh.view()).value();
    EXPECT_EQ(field.checksum(), expected.checksum()) << hwy::TargetName(target);
    test::Random random(5);
    for (int i = 0; i < 500; ++i) {
      const Vec3 p = random.in({{-2, -2, -2}, {2, 2, 2}});
      EXPECT_TRUE(test::same_bits(field.closest(p), expected.closest(p))) << hwy::TargetName(target);
    }
  }
  hwy::SetSupportedTargetsForTest(0);
}

TEST(SameAnswer, ChecksumTellsFieldsApart) {
  const Mesh mesh = test::sphere_mesh(3);
  Mesh moved = mesh;
  moved.vertices[0].x += 0x1p-10;
  BuildOptions fewer;
  fewer.max_triangles_per_leaf = 16;
  const std::uint64_t sum = Field::build(mesh.view()).value().checksum();
  EXPECT_NE(Field::build(moved.view()).value().checksum(), sum);
  EXPECT_NE(Field::build(mesh.view(), fewer).value().checksum(), sum);
}

/// A point's answer does not depend on how deep the octree is.
TEST(SameAnswer, AtAnyResolution) {
  const Mesh mesh = test::sphere_mesh(4);
  const Field expected = Field::build(mesh.view()).value();
  for (const int level : {0, 1, 3}) {
    for (const Lists lists : {Lists::corner, Lists::band}) {
      BuildOptions options;
      options.max_level = level;
      options.max_triangles_per_leaf = 16;
      options.lists = lists;
      const Field field = Field::build(mesh.view(), options).value();
      test::Random random(9);
      for (int i = 0; i < 500; ++i) {
        const Vec3 p = random.in({{-1.5, -1.5, -1.5}, {1.5, 1.5, 1.5}});
        ASSERT_TRUE(test::same_bits(field.closest(p), expected.closest(p)));
      }
    }
  }
}

}  // namespace
}  // namespace cdfr
