#include "geometry/place_estimate.h"

#include <gtest/gtest.h>

#include "geometry/kernel_cases.h"

namespace cdfr {
namespace {

TEST(PlaceEstimate, WhatItIsSureOfIsWhatDoubleDoubleDecides) {
  PlaceEstimate nothing_known;
  nothing_known.may_be_least = {true, true, true};
  test::Random random(31);
  int sure[7] = {};
  for (int i = 0; i < 300000; ++i) {
    const test::KernelCase c = test::random_kernel_case(random);
    const PlaceEstimate estimate = estimate_place(c.p, c.triangle);
    const Foot decided = measure(c.p, c.triangle, nothing_known);
    ASSERT_TRUE(test::same_bits(measure(c.p, c.triangle, estimate), decided)) << i;
    if (estimate.place == unsure_place) continue;
    ++sure[estimate.place];
    ASSERT_EQ(estimate.place, decided.place);
    ASSERT_TRUE(estimate.place == 0 || decided.squared.hi > 0);
  }
  for (const int count : sure) EXPECT_GT(count, 5000);
}

TEST(PlaceEstimate, IsSureNearlyAlwaysAwayFromBorders) {
  test::Random random(32);
  const Box box{{-1, -1, -1}, {1, 1, 1}};
  int unsure = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vec3 a = random.in(box), b = random.in(box), c = random.in(box), p = random.in(box);
    unsure += estimate_place(p, {{a, b, c}, unit_normal(a, b, c)}).place == unsure_place;
  }
  EXPECT_LE(unsure, 2);
}

}  // namespace
}  // namespace cdfr
