#include "octree/build.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "mesh/topology.h"
#include "octree/built_octree.h"
#include "octree/search.h"
#include "support/meshes.h"

namespace cdfr {
namespace {

/// A mesh, its BVH and an octree over it.
struct Built {
  Mesh mesh;
  Bvh bvh;
  TriangleStore triangles;
  Octree tree;

  Built(Mesh m, const BuildOptions& options) : mesh(std::move(m)) {
    BvhAndOrder ordered = build_bvh(mesh.view());
    bvh = std::move(ordered.bvh);
    triangles = gather_triangles(mesh.view(), weld_topology(mesh.view()), ordered.order);
    tree = test::build_octree({triangles, bvh}, lattice_for(bvh.nodes[0].box, options.margin), options);
  }
};

struct LeafAt {
  Cell cell;
  std::uint32_t number;
};

std::vector<LeafAt> leaves_of(const Block& block) {
  std::vector<LeafAt> found;
  const auto walk = [&](const auto& self, const Cell& cell, std::uint32_t node) -> void {
    if (block.nodes[node].is_leaf()) {
      found.push_back({cell, block.nodes[node].leaf_number()});
      return;
    }
    for (int child = 0; child < 8; ++child) {
      self(self, child_of(cell, child), block.nodes[node].first_child() + static_cast<unsigned>(child));
    }
  };
  walk(walk, cell_of(block.key), 0);
  return found;
}

std::uint64_t length(const Built& built, const Block& block, const LeafRecord& leaf) {
  std::uint64_t sum = 0;
  for (std::uint32_t i = leaf.first; i < leaf.first + leaf.count(); ++i) {
    const Entry& entry = block.entries[i];
    const auto [first, end] = groups_of(built.bvh, entry);
    sum += entry.is_group() ? static_cast<std::uint64_t>(std::popcount(entry.lanes()))
                            : std::uint64_t{end - first} * group_size;
  }
  return sum;
}

std::vector<Block> blocks_of(const Octree& tree) {
  std::vector<Block> blocks;
  for (std::size_t i = 0; i < tree.block_count(); ++i) blocks.push_back(tree.block(i));
  return blocks;
}

TEST(BuildOctree, LeavesTileTheBrickInMortonOrder) {
  const Built built(test::sphere_mesh(3), {});
  const Box domain = built.tree.lattice.domain();
  double volume = 0;
  std::uint64_t last = 0;
  for (const Block& block : blocks_of(built.tree)) {
    std::uint32_t expected = 0;
    for (const LeafAt& leaf : leaves_of(block)) {
      EXPECT_EQ(leaf.number, expected++);
      const double s = built.tree.lattice.size(leaf.cell.level);
      volume += s * s * s;
      const std::uint64_t place = key_of(leaf.cell) << (3 * (deepest_level - leaf.cell.level));
      EXPECT_GT(place, last);
      last = place;
    }
    EXPECT_EQ(expected, block.leaves.size());
  }
  EXPECT_EQ(volume, (domain.hi.x - domain.lo.x) * (domain.hi.y - domain.lo.y) * (domain.hi.z - domain.lo.z));
}

TEST(BuildOctree, ListsAscendAndNameNothingTwice) {
  const Built built(test::soup(300, {{0, 0, 0}, {1, 1, 1}}, 4), {});
  for (const Block& block : blocks_of(built.tree)) {
    for (const LeafRecord& leaf : block.leaves) {
      ASSERT_GT(leaf.count(), 0U);
      std::set<std::uint32_t> groups;
      for (std::uint32_t i = leaf.first; i < leaf.first + leaf.count(); ++i) {
        const Entry& entry = block.entries[i];
        if (i > leaf.first) {
          EXPECT_LE(block.entries[i - 1].distance(), entry.distance());
        }
        EXPECT_NE(entry.lanes(), 0);
        const auto [first, end] = groups_of(built.bvh, entry);
        for (std::uint32_t g = first; g < end; ++g) EXPECT_TRUE(groups.insert(g).second);
      }
    }
  }
}

TEST(BuildOctree, WithoutTheGainTestEveryLongLeafIsAtTheDeepestLevel) {
  BuildOptions options;
  options.gain = 1;
  options.max_level = 3;
  options.max_triangles_per_leaf = 20;
  const Built built(test::sphere_mesh(4), options);
  bool some_long = false;
  for (const Block& block : blocks_of(built.tree)) {
    for (const LeafAt& leaf : leaves_of(block)) {
      EXPECT_LE(leaf.cell.level, 3);
      if (length(built, block, block.leaves[leaf.number]) <= 20) continue;
      some_long = true;
      EXPECT_EQ(leaf.cell.level, 3);
    }
  }
  EXPECT_TRUE(some_long);
}

TEST(BuildOctree, LevelCountsAddUp) {
  const Built built(test::sphere_mesh(4), {});
  for (std::size_t level = 0; level < built.tree.levels.size(); ++level) {
    const LevelStats& l = built.tree.levels[level];
    EXPECT_EQ(l.entries_in, l.entries_kept + l.entries_pruned);
    const std::uint64_t next = level + 1 < built.tree.levels.size() ? built.tree.levels[level + 1].cells : 0;
    EXPECT_EQ((l.cells - l.leaves) * 8, next);
  }
}

TEST(BuildOctree, TheBandKeepsAllThatCornersKeepAndMore) {
  BuildOptions options;
  options.max_level = 0;
  const Built corner(test::sphere_mesh(4), options);
  options.lists = Lists::band;
  const Built band(test::sphere_mesh(4), options);
  std::uint64_t corners = 0, bands = 0;
  ASSERT_EQ(corner.tree.block_count(), band.tree.block_count());
  for (std::size_t b = 0; b < corner.tree.block_count(); ++b) {
    const Block tight = corner.tree.block(b), wide = band.tree.block(b);
    corners += length(corner, tight, tight.leaves[0]);
    bands += length(band, wide, wide.leaves[0]);
  }
  EXPECT_LT(2 * corners, bands);
}

TEST(BuildOctree, SurvivesWhatCannotBeSplitApart) {
  Mesh heap;
  heap.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  heap.triangles.assign(5000, {0, 1, 2});
  BuildOptions options;
  options.max_level = 18;
  const Built built(std::move(heap), options);
  EXPECT_LE(built.tree.levels.size(), 2U);  // no split pays: the gain test stops it
}

}  // namespace
}  // namespace cdfr
