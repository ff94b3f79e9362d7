#include "octree/build.h"

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/parallel.h"
#include "octree/block_builder.h"
#include "octree/refine.h"

namespace cdfr {
namespace {

/// Places keys of any level along one Morton curve.
std::uint64_t morton_place(const Cell& cell) noexcept {
  return key_of(cell) << (3 * (deepest_level - cell.level));
}

using Scratches = tbb::enumerable_thread_specific<RefineScratch>;

struct Pending {
  OpenCell open;
  std::uint32_t node = 0;       ///< in Octree::top
  std::uint64_t inherited = 0;  ///< triangles of the parent's list
};

/// Refines from the virtual cube down until lists are short enough for one block each.
std::vector<Pending> cut_into_blocks(SearchSpace space, const RefineOptions& refining, Scratches& scratches,
                                     Octree& tree, Progress& progress) {
  std::vector<Pending> seeds;
  std::vector<Pending> frontier;
  frontier.push_back({root_cell(space), 0, 0});
  tree.top.resize(1);
  while (!frontier.empty() && !progress.cancelled()) {
    std::vector<std::array<OpenCell, 8>> refined(frontier.size());
    for_chunks(frontier.size(), 1, [&](std::size_t i, std::size_t) {
      if (!progress.poll()) return;
      refined[i] = refine(space, tree.lattice, frontier[i].open, refining, scratches.local());
    });
    std::vector<Pending> next;
    for (std::size_t i = 0; i < frontier.size(); ++i) {
      const auto first = static_cast<std::uint32_t>(tree.top.size());
      tree.top[frontier[i].node] = TreeNode::inner(first);
      tree.top.resize(first + 8, TreeNode::leaf(Octree::no_block));
      for (std::uint32_t child = 0; child < 8; ++child) {
        OpenCell& cell = refined[i][child];
        if (!tree.lattice.meets_brick(cell.cell)) continue;
        const bool rooted =
            cell.cell.level >= 0 && (cell.triangles <= block_triangles || cell.cell.level == block_deepest);
        (rooted ? seeds : next).push_back({std::move(cell), first + child, frontier[i].open.triangles});
      }
    }
    frontier = std::move(next);
  }
  std::sort(seeds.begin(), seeds.end(), [](const Pending& a, const Pending& b) {
    return morton_place(a.open.cell) < morton_place(b.open.cell);
  });
  return seeds;
}

/// Lists of so many triangles are taken apart to groups: those that splits will bring down to a leaf's
/// length. Much longer ones cost less as nodes of the BVH, in the build and in a query, which descends into
/// few.
std::uint64_t opened_below(int max_triangles_per_leaf) noexcept {
  return std::clamp<std::uint64_t>(16 * static_cast<std::uint64_t>(max_triangles_per_leaf), 1024, 4096);
}

/// A block's share of the octree's leaves goes by its list. With the gain test off all splits are wanted.
std::uint64_t most_leaves(const BuildOptions& options, std::uint64_t triangles, std::uint64_t listed,
                          std::uint64_t listed_in_all) noexcept {
  if (options.gain >= 1) return ~std::uint64_t{0} / 2;
  const double length = options.max_triangles_per_leaf;
  const double all =
      leaves_in_all + leaves_a_triangle * static_cast<double>(triangles) / (length * std::sqrt(length));
  return 8 +
         static_cast<std::uint64_t>(all * static_cast<double>(listed) / static_cast<double>(listed_in_all));
}

void add(std::vector<LevelStats>& sum, const std::vector<LevelStats>& part) {
  if (sum.size() < part.size()) sum.resize(part.size());
  for (std::size_t level = 0; level < part.size(); ++level) {
    sum[level].level = static_cast<int>(level);
    sum[level].cells += part[level].cells;
    sum[level].leaves += part[level].leaves;
    sum[level].entries_in += part[level].entries_in;
    sum[level].entries_pruned += part[level].entries_pruned;
    sum[level].entries_kept += part[level].entries_kept;
  }
}

}  // namespace

Octree build_octree(SearchSpace space, const Lattice& lattice, const BuildOptions& options,
                    Progress& progress) {
  Octree tree;
  tree.lattice = lattice;
  const RefineOptions refining{options.lists, opened_below(options.max_triangles_per_leaf)};
  Scratches scratches;
  std::vector<Pending> seeds = cut_into_blocks(space, refining, scratches, tree, progress);
  std::uint64_t rooted = 0;
  for (const Pending& seed : seeds) rooted += seed.open.triangles;
  std::vector<std::vector<LevelStats>> levels(seeds.size());
  tree.blocks.resize(seeds.size());
  progress.phase(0.2, 0.9, static_cast<double>(seeds.size()));
  for_chunks(seeds.size(), 1, [&](std::size_t i, std::size_t) {
    if (progress.cancelled()) return;
    const std::uint64_t most = most_leaves(options, space.triangles.size(), seeds[i].open.triangles, rooted);
    BlockBuilder builder(space, lattice, options, refining, scratches.local(), most, progress);
    tree.blocks[i] = builder.build(std::move(seeds[i].open), seeds[i].inherited);
    levels[i] = builder.levels();
    progress.step();
  });
  for (std::size_t i = 0; i < seeds.size(); ++i) {
    tree.top[seeds[i].node] = TreeNode::leaf(static_cast<std::uint32_t>(i));
    add(tree.levels, levels[i]);
  }
  return tree;
}

}  // namespace cdfr
