// Completeness shown directly: the brute-force winner of any point of a leaf is in the leaf's own list.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "cdfr/field/field.h"
#include "octree/key.h"
#include "support/meshes.h"

namespace cdfr {
namespace {

struct Named {
  const char* name;
  Mesh mesh;
};

std::vector<Named> meshes() {
  std::vector<Named> all;
  all.push_back({"box", test::box_mesh({{-1, 0, 0.1}, {2, 1, 3}})});
  all.push_back({"sphere", test::sphere_mesh(4)});
  all.push_back({"far sphere", test::sphere_mesh(3, 1, {1e6, -1e6, 3e5})});
  all.push_back({"tiny sphere", test::sphere_mesh(2, 0x1p-190)});
  all.push_back({"soup", test::soup(150, {{0, 0, 0}, {1, 1, 1}}, 5)});
  all.push_back({"plate", test::box_mesh({{0, 0, 0}, {100, 80, 1e-6}})});
  all.push_back({"needle", test::box_mesh({{0, 0, 0}, {1, 1e-12, 1e-12}})});
  return all;
}

/// A point of the closed cell: inside, on faces, edges, corners, or on the mid-planes where it would be cut
/// next.
Vec3 point_of(test::Random& random, const Box& b) {
  const auto pick = [&](double lo, double hi) {
    switch (random.below(6)) {
      case 0:
        return lo;
      case 1:
        return hi;
      case 2:
        return lo + (hi - lo) / 2;
      default:
        return random.between(lo, hi);
    }
  };
  return {pick(b.lo.x, b.hi.x), pick(b.lo.y, b.hi.y), pick(b.lo.z, b.hi.z)};
}

TEST(Completeness, TheWinnerIsInTheLeafsOwnList) {
  for (const Named& m : meshes()) {
    for (const Lists lists : {Lists::corner, Lists::band}) {
      BuildOptions options;
      options.lists = lists;
      options.max_triangles_per_leaf = 8;
      options.max_level = 2;
      const Field field = Field::build(m.mesh.view(), options).value();
      const BruteForce brute = BruteForce::over(m.mesh.view()).value();
      test::Random random(7);
      for (int i = 0; i < 300; ++i) {
        const Leaf leaf = field.leaf(random.below(field.leaf_count()));
        for (int k = 0; k < 4; ++k) {
          const Vec3 p = point_of(random, leaf.box);
          const std::uint32_t winner = brute.closest(p).triangle;
          ASSERT_TRUE(std::binary_search(leaf.triangles.begin(), leaf.triangles.end(), winner)) << m.name;
        }
      }
    }
  }
}

/// The source paper lets each cell look at its 26 neighbours' lists for what it lacks (papers/huang-2001,
/// section 3.4). Done to leaves of equal level here, nothing that comes in ever wins.
TEST(Completeness, NeighboursHaveNothingToAdd) {
  for (const Named& m : meshes()) {
    BuildOptions options;
    options.max_triangles_per_leaf = 8;
    options.max_level = 2;
    const Field field = Field::build(m.mesh.view(), options).value();
    std::map<std::uint64_t, Leaf> leaves;
    field.for_each_leaf([&](const Leaf& leaf) { leaves.emplace(leaf.key, leaf); });
    const BruteForce brute = BruteForce::over(m.mesh.view(), Sign::none).value();
    test::Random random(8);
    int gained = 0, tried = 0;
    for (const auto& [key, leaf] : leaves) {
      if (random.below(leaves.size()) > 60) continue;
      const Cell cell = cell_of(key);
      std::set<std::uint32_t> incoming;
      for (int n = 0; n < 27; ++n) {
        Cell neighbour = cell;
        neighbour.place[0] += static_cast<std::uint32_t>(n % 3 - 1);
        neighbour.place[1] += static_cast<std::uint32_t>(n / 3 % 3 - 1);
        neighbour.place[2] += static_cast<std::uint32_t>(n / 9 - 1);
        const auto at = leaves.find(key_of(neighbour));
        if (at != leaves.end()) incoming.insert(at->second.triangles.begin(), at->second.triangles.end());
      }
      for (const std::uint32_t own : leaf.triangles) incoming.erase(own);
      gained += static_cast<int>(incoming.size());
      for (int k = 0; k < 6; ++k, ++tried) {
        ASSERT_EQ(incoming.count(brute.closest(point_of(random, leaf.box)).triangle), 0U) << m.name;
      }
    }
    EXPECT_GT(tried, 0) << m.name;
    RecordProperty(m.name, gained);
  }
}

}  // namespace
}  // namespace cdfr
