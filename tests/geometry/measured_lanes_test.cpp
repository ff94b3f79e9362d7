#include "geometry/measured_lanes.h"

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <bit>

#include "geometry/kernel_cases.h"

namespace cdfr {
namespace {

void expect_as_one_by_one(const PairLanes& pairs) {
  MeasuredLanes measured;
  measure(pairs, measured);
  for (std::size_t lane = 0; lane < lane_count; ++lane) {
    const Foot foot = measure(pairs.p(lane), pairs.triangle(lane));
    ASSERT_TRUE(test::same_bits(measured.foot(pairs, lane), foot));
    ASSERT_EQ(std::bit_cast<std::uint64_t>(measured.distance[lane]),
              std::bit_cast<std::uint64_t>(square_root(foot.squared)));
  }
}

/// The same on every instruction set of this processor.
template <class Check>
void on_every_set(Check check) {
  for (std::int64_t targets = hwy::SupportedTargets(); targets != 0; targets &= targets - 1) {
    hwy::SetSupportedTargetsForTest(targets & -targets);
    SCOPED_TRACE(hwy::TargetName(targets & -targets));
    check();
  }
  hwy::SetSupportedTargetsForTest(0);
}

TEST(MeasuredLanes, HaveTheBitsOfTheKernel) {
  on_every_set([] {
    test::Random random(41);
    for (int i = 0; i < 4000; ++i) {
      PairLanes pairs;
      for (std::size_t lane = 0; lane < lane_count; ++lane) {
        const test::KernelCase c = test::random_kernel_case(random);
        pairs.set(lane, c.p, c.triangle);
      }
      expect_as_one_by_one(pairs);
    }
  });
}

TEST(MeasuredLanes, MayAllLieOnFacesOrAllBesideThem) {
  on_every_set([] {
    test::Random random(42);
    for (const bool faces : {true, false}) {
      PairLanes pairs;
      for (std::size_t lane = 0; lane < lane_count;) {
        const test::KernelCase c = test::random_kernel_case(random);
        if ((estimate_place(c.p, c.triangle).place == 0) != faces) continue;
        pairs.set(lane++, c.p, c.triangle);
      }
      expect_as_one_by_one(pairs);
    }
  });
}

}  // namespace
}  // namespace cdfr
