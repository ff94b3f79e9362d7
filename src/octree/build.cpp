#include "octree/build.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
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

/// Lists of so many triangles are taken apart to groups: those that splits will bring down to a leaf's
/// length. Much longer ones cost less as nodes of the BVH, in the build and in a query, which descends into
/// few.
std::uint64_t opened_below(int max_triangles_per_leaf) noexcept {
  return std::clamp<std::uint64_t>(16 * static_cast<std::uint64_t>(max_triangles_per_leaf), 1024, 4096);
}

}  // namespace

struct BlockCut::Pending {
  Seed seed;
  std::uint32_t node = 0;  ///< of the top tree
};

BlockCut::BlockCut(SearchSpace space, const Lattice& lattice, const BuildOptions& options, Progress& progress,
                   LeftOut left_out)
    : space_(space),
      lattice_(lattice),
      options_(options),
      refining_{options.lists, opened_below(options.max_triangles_per_leaf)},
      progress_(progress),
      left_out_(std::move(left_out)) {
  cut();
  for (const Seed& seed : seeds_) listed_ += seed.open.triangles;
}

void BlockCut::cut() {
  std::vector<TreeNode> top(1);
  std::vector<Pending> roots;
  std::vector<Pending> frontier;
  frontier.push_back({{root_cell(space_), 0}, 0});
  while (!frontier.empty() && !progress_.cancelled()) {
    std::vector<std::array<OpenCell, 8>> refined(frontier.size());
    for_chunks(frontier.size(), 1, [&](std::size_t i, std::size_t) {
      if (!progress_.poll()) return;
      refined[i] = refine(space_, lattice_, frontier[i].seed.open, refining_, scratches_.local());
    });
    std::vector<Pending> next;
    for (std::size_t i = 0; i < frontier.size(); ++i) {
      const auto first = static_cast<std::uint32_t>(top.size());
      top[frontier[i].node] = TreeNode::inner(first);
      top.resize(first + 8, TreeNode::leaf(Octree::no_block));
      for (std::uint32_t child = 0; child < 8; ++child) {
        OpenCell& cell = refined[i][child];
        if (!lattice_.meets_brick(cell.cell)) continue;
        const bool rooted =
            cell.cell.level >= 0 && (cell.triangles <= block_triangles || cell.cell.level == block_deepest);
        (rooted ? roots : next)
            .push_back({{std::move(cell), frontier[i].seed.open.triangles}, first + child});
      }
    }
    frontier = std::move(next);
  }
  std::sort(roots.begin(), roots.end(), [](const Pending& a, const Pending& b) {
    return morton_place(a.seed.open.cell) < morton_place(b.seed.open.cell);
  });
  for (std::size_t i = 0; i < roots.size(); ++i) {
    top[roots[i].node] = TreeNode::leaf(static_cast<std::uint32_t>(i));
    seeds_.push_back(std::move(roots[i].seed));
  }
  top_ = std::move(top);
}

Octree BlockCut::octree() const {
  Octree tree;
  tree.lattice = lattice_;
  tree.top = top_;
  return tree;
}

/// A block's share of the octree's leaves goes by its list. With the gain test off all splits are wanted.
std::uint64_t BlockCut::most_leaves(const OpenCell& root) const noexcept {
  if (options_.gain >= 1) return ~std::uint64_t{0} / 2;
  const double length = options_.max_triangles_per_leaf;
  const double all = leaves_in_all + leaves_a_triangle * static_cast<double>(space_.triangles.size()) /
                                         (length * std::sqrt(length));
  return 8 +
         static_cast<std::uint64_t>(all * static_cast<double>(root.triangles) / static_cast<double>(listed_));
}

BuiltBlock BlockCut::build(std::size_t number) {
  Seed& seed = seeds_[number];
  BlockBuilder builder(space_, lattice_, options_, refining_, scratches_.local(), most_leaves(seed.open),
                       left_out_, progress_);
  Block block = builder.build(std::move(seed.open), seed.inherited);
  return {std::move(block), builder.levels()};
}

void add_levels(std::vector<LevelStats>& sum, const std::vector<LevelStats>& part) {
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

}  // namespace cdfr
