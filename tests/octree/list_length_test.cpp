#include "octree/list_length.h"

#include <gtest/gtest.h>

#include <cstdint>

#include "cdfr/field/field.h"
#include "cdfr/octree/options.h"
#include "support/meshes.h"
#include "support/same.h"

namespace cdfr {
namespace {

TEST(ListLength, FewerQueriesWantLongerLists) {
  for (const std::uint64_t triangles : {1ULL, 12ULL, 23'062ULL, 1'000'000ULL, 0xfffffffeULL}) {
    int last = list_length_for(triangles, ~std::uint64_t{0});
    EXPECT_EQ(last, BuildOptions{}.max_triangles_per_leaf) << triangles;
    for (std::uint64_t queries = std::uint64_t{1} << 63; queries > 0; queries /= 2) {
      const int length = list_length_for(triangles, queries);
      EXPECT_GE(length, last) << triangles << ' ' << queries;
      last = length;
    }
  }
}

TEST(ListLength, OneQueryWantsNoSplits) {
  for (const std::uint64_t triangles : {12ULL, 1000ULL, 134'480ULL}) {
    EXPECT_GE(static_cast<std::uint64_t>(list_length_for(triangles, 1)), triangles / 2);
  }
}

TEST(ListLength, TheDefaultSuitsTenMillion) {
  EXPECT_EQ(list_length_for(134'480, 10'000'000), BuildOptions{}.max_triangles_per_leaf);
}

/// The lists are chosen and told, and answers do not depend on them.
TEST(ListLength, FieldsForFewQueriesAnswerAsBruteForceDoes) {
  const Mesh mesh = test::sphere_mesh(5);
  const BruteForce brute = BruteForce::over(mesh.view()).value();
  std::uint64_t last = 0;
  for (const std::uint64_t queries : {1ULL, 1000ULL, 100'000ULL, 10'000'000ULL}) {
    const Field field = Field::build(mesh.view(), {.expected_queries = queries}).value();
    EXPECT_EQ(field.options().expected_queries, 0U);
    EXPECT_EQ(field.options().max_triangles_per_leaf, list_length_for(mesh.triangles.size(), queries));
    EXPECT_GE(field.leaf_count(), last);
    last = field.leaf_count();
    test::Random random(9);
    for (int i = 0; i < 100; ++i) {
      const Vec3 p = random.in({{-1.5, -1.5, -1.5}, {1.5, 1.5, 1.5}});
      ASSERT_TRUE(test::same_bits(field.closest(p), brute.closest(p))) << queries;
    }
  }
}

}  // namespace
}  // namespace cdfr
