// The race against its rule: the least computed squared distance, ties to the lowest number, in any order.
#include "field/race.h"

#include <gtest/gtest.h>

#include <cstring>
#include <numeric>
#include <utility>

#include "geometry/query_range.h"
#include "mesh/topology.h"
#include "support/meshes.h"

namespace cdfr {
namespace {

TriangleStore store_of(const Mesh& mesh) {
  std::vector<std::uint32_t> order(mesh.triangles.size());
  std::iota(order.begin(), order.end(), 0U);
  return gather_triangles(mesh.view(), weld_topology(mesh.view()), order);
}

void shuffle(std::vector<std::uint32_t>& slots, test::Random& random) {
  for (std::size_t i = slots.size(); i > 1; --i) std::swap(slots[i - 1], slots[random.below(i)]);
}

std::uint32_t least(const TriangleStore& store, const Vec3& p) {
  std::uint32_t best = 0;
  for (std::uint32_t slot = 1; slot < store.size(); ++slot) {
    if (measure(p, store.shape(slot)).squared < measure(p, store.shape(best)).squared) best = slot;
  }
  return best;
}

template <class Value>
bool same_bits(const Value& a, const Value& b) {
  return std::memcmp(&a, &b, sizeof(Value)) == 0;
}

void expect_rule(const TriangleStore& store, const Vec3& p, test::Random& random) {
  const std::uint32_t expected = least(store, p);
  const Foot foot = measure(p, store.shape(expected));
  std::vector<std::uint32_t> slots(store.size());
  std::iota(slots.begin(), slots.end(), 0U);
  for (int order = 0; order < 4; ++order) {
    Race race(p, store, largest_magnitude(p) + 4);
    for (const std::uint32_t slot : slots) race.challenge(slot);
    const Finding finding = race.finding();
    ASSERT_EQ(finding.winner.slot, expected);
    EXPECT_EQ(finding.winner.number, store.records[expected].number);
    EXPECT_EQ(finding.winner.foot.place, foot.place);
    EXPECT_TRUE(same_bits(finding.winner.foot.squared, foot.squared));
    EXPECT_TRUE(same_bits(finding.winner.foot.offset, foot.offset));
    EXPECT_TRUE(same_bits(finding.winner.foot.along, foot.along));
    shuffle(slots, random);
  }
}

TEST(Race, GivesTheLowestOfTheLeastInAnyOrder) {
  test::Random random(51);
  for (const Mesh& mesh : {test::sphere_mesh(1), test::box_mesh({{-1, -1, -1}, {1, 1, 1}}),
                           test::soup(40, {{-1, -1, -1}, {1, 1, 1}}, 3)}) {
    const TriangleStore store = store_of(mesh);
    for (int i = 0; i < 300; ++i) expect_rule(store, random.in({{-3, -3, -3}, {3, 3, 3}}), random);
    for (const Vec3& v : mesh.vertices) {
      expect_rule(store, v, random);
      expect_rule(store, {2 * v.x, 2 * v.y, 2 * v.z}, random);
    }
  }
}

/// Equal coordinates may differ in the sign of a zero from triangle to triangle.
TEST(Race, SharesAFootAcrossZerosOfEitherSign) {
  Mesh mesh;
  mesh.vertices = {{0.0, 0.0, 0.0}, {1, 0.0, 0.5}, {0, 1, 0}, {-0.0, -0.0, -0.0}, {1, -0.0, 0.5}, {0, -1, 0}};
  mesh.triangles = {{0, 1, 2}, {4, 3, 5}};
  const TriangleStore store = store_of(mesh);
  test::Random random(52);
  expect_rule(store, {0.5, 0, 1}, random);
  expect_rule(store, {0.5, 0, -3}, random);
  expect_rule(store, {-1, 0, 0}, random);
}

TEST(Race, KnowsRivalsThatRoundingCannotTellApart) {
  const TriangleStore store = store_of(test::box_mesh({{-1, -1, -1}, {1, 1, 1}}));
  Race race({0, 0, 0}, store, 4);
  for (std::uint32_t slot = 0; slot < store.size(); ++slot) race.challenge(slot);
  EXPECT_TRUE(race.finding().crowded);
  Race corner({2, 2, 2}, store, 4);
  for (std::uint32_t slot = 0; slot < store.size(); ++slot) corner.challenge(slot);
  EXPECT_FALSE(corner.finding().crowded);
  EXPECT_EQ(corner.finding().rival_count, 0);
}

}  // namespace
}  // namespace cdfr
