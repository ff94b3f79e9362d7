// Promise 3: byte-identical files, however the field was built.
#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <cstdint>
#include <cstring>

#include "store/format.h"
#include "store/stored_bytes.h"
#include "support/meshes.h"

namespace cdfr {
namespace {

class StoreBytes : public StoreTest {};

TEST_F(StoreBytes, AreTheSameForEverySave) {
  const Mesh mesh = test::sphere_mesh(3);
  const std::string first = saved(Field::build(mesh.view()).value(), "mm");
  EXPECT_EQ(saved(Field::build(mesh.view()).value(), "mm"), first);
  EXPECT_NE(saved(Field::build(mesh.view()).value(), "in"), first);
}

TEST_F(StoreBytes, AreTheSameForAnyThreads) {
  for (const Mesh& mesh : {test::sphere_mesh(4), test::soup(120, {{0, 0, 0}, {1, 1, 1}}, 6)}) {
    cdfr::Run run;
    run.threads = 1;
    const std::string expected = saved(Field::build(mesh.view(), {}, run).value());
    for (const unsigned threads : {2U, 7U}) {
      run.threads = threads;
      EXPECT_TRUE(saved(Field::build(mesh.view(), {}, run).value()) == expected) << threads;
    }
  }
}

TEST_F(StoreBytes, AreTheSameOnEveryInstructionSetOfThisMachine) {
  for (const Mesh& mesh : {test::sphere_mesh(3), test::soup(60, {{0, 0, 0}, {1, 1, 1}}, 7)}) {
    const std::string expected = saved(Field::build(mesh.view()).value());
    for (std::int64_t targets = hwy::SupportedTargets(); targets != 0; targets &= targets - 1) {
      const std::int64_t target = targets & -targets;
      hwy::SetSupportedTargetsForTest(target);
      EXPECT_TRUE(saved(Field::build(mesh.view()).value()) == expected) << hwy::TargetName(target);
      hwy::SetSupportedTargetsForTest(0);
    }
  }
}

TEST_F(StoreBytes, FollowTheLayout) {
  const std::string bytes = saved(Field::build(test::sphere_mesh(2).view()).value(), "mm");
  format::Head head;
  ASSERT_GT(bytes.size(), sizeof head);
  std::memcpy(&head, bytes.data(), sizeof head);
  EXPECT_EQ(head.magic, format::magic);
  EXPECT_EQ(head.version, format::version);
  EXPECT_EQ(head.sections, std::uint32_t{format::section_count});
  EXPECT_EQ(head.file_size, bytes.size());
  EXPECT_EQ(head.packing, 0U);
  EXPECT_EQ(head.zero, 0U);
  for (const std::uint64_t word : head.zeros) EXPECT_EQ(word, 0U);
  format::Counts counts;
  std::memcpy(&counts, bytes.data() + sizeof head, sizeof counts);
  EXPECT_EQ(format::Places(counts).file_size(), bytes.size());
  EXPECT_EQ(counts[format::unit], 2U);
  EXPECT_EQ(counts[format::records], 128U);
}

}  // namespace
}  // namespace cdfr
