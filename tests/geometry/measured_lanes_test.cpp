#include "geometry/measured_lanes.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>

#include "geometry/kernel_cases.h"
#include "support/instruction_sets.h"

namespace cdfr {
namespace {

void expect_foot(const MeasuredLanes& measured, std::size_t lane, const Vec3& p,
                 const TriangleShape& triangle) {
  const Foot foot = measure(p, triangle);
  ASSERT_TRUE(test::same_bits(measured.foot(triangle, lane), foot));
  ASSERT_EQ(std::bit_cast<std::uint64_t>(measured.distance[lane]),
            std::bit_cast<std::uint64_t>(square_root(foot.squared)));
}

void expect_as_one_by_one(const PairLanes& pairs) {
  MeasuredLanes measured;
  measure(pairs, measured);
  for (std::size_t lane = 0; lane < lane_count; ++lane) {
    expect_foot(measured, lane, pairs.p(lane), pairs.triangle(lane));
  }
}

TEST(MeasuredLanes, HaveTheBitsOfTheKernel) {
  test::on_every_instruction_set([] {
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
  test::on_every_instruction_set([] {
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

/// Points of one triangle whose feet are at one place, wherever that is.
TEST(MeasuredLanes, MayMeetOneTriangleAtAPlaceThatIsKnown) {
  test::on_every_instruction_set([] {
    test::Random random(43);
    std::array<int, 7> met{};
    for (int i = 0; i < 6000; ++i) {
      const test::KernelCase c = test::random_kernel_case(random);
      const TrianglePlace place = estimate_place(c.p, c.triangle).place;
      if (place == unsure_place) continue;
      PointLanes points;
      for (std::size_t lane = 0; lane < lane_count; ++lane) {
        const Vec3 q =
            test::toward(c.p, c.triangle.vertices[lane % 3], test::power_below_one(random, 30) / 2);
        points.set(lane, estimate_place(q, c.triangle).place == place ? q : c.p);
      }
      MeasuredLanes measured;
      measure_at(c.triangle, place, points, measured);
      for (std::size_t lane = 0; lane < lane_count; ++lane) {
        expect_foot(measured, lane, points.p(lane), c.triangle);
      }
      ++met[place];
    }
    for (const int times : met) EXPECT_GT(times, 10);
  });
}

}  // namespace
}  // namespace cdfr
