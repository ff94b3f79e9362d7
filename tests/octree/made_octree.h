/// Octrees made at random, with no mesh behind them: every depth of blocks and leaves comes up.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "octree/blocks.h"
#include "octree/build.h"
#include "support/random.h"

namespace cdfr::test {

class OctreeMaker {
 public:
  /// Leaves are at most at that level; each cell above it splits with that chance.
  OctreeMaker(Random& random, const Lattice& lattice, int deepest, double chance)
      : random_(random), deepest_(deepest), chance_(chance) {
    tree_.lattice = lattice;
  }

  Octree made() {
    top_.resize(1);
    cut({}, 0);
    tree_.top = std::move(top_);
    join(tree_, std::move(blocks_));
    return std::move(tree_);
  }

 private:
  struct Growing {
    std::vector<TreeNode> nodes;
    std::vector<LeafRecord> leaves;
    std::vector<Entry> entries;
  };

  bool splits(const Cell& cell) { return cell.level < deepest_ && random_.between(0, 1) < chance_; }

  void cut(const Cell& cell, std::size_t at) {
    if (!tree_.lattice.meets_brick(cell)) {
      top_[at] = TreeNode::leaf(Octree::no_block);
    } else if (cell.level >= 0 && (cell.level == block_deepest || !splits(cell))) {
      top_[at] = TreeNode::leaf(static_cast<std::uint32_t>(blocks_.size()));
      Growing block;
      block.nodes.resize(1);
      grow(block, cell, 0);
      blocks_.push_back(
          {key_of(cell), std::move(block.nodes), std::move(block.leaves), std::move(block.entries)});
    } else {
      const std::size_t first = top_.size();
      top_[at] = TreeNode::inner(static_cast<std::uint32_t>(first));
      top_.resize(first + 8);
      for (int i = 0; i < 8; ++i) cut(child_of(cell, i), first + static_cast<std::size_t>(i));
    }
  }

  void grow(Growing& block, const Cell& cell, std::size_t at) {
    if (splits(cell)) {
      const std::size_t first = block.nodes.size();
      block.nodes[at] = TreeNode::inner(static_cast<std::uint32_t>(first));
      block.nodes.resize(first + 8);
      for (int i = 0; i < 8; ++i) grow(block, child_of(cell, i), first + static_cast<std::size_t>(i));
      return;
    }
    block.nodes[at] = TreeNode::leaf(static_cast<std::uint32_t>(block.leaves.size()));
    LeafRecord leaf{static_cast<std::uint32_t>(block.entries.size()), 0};
    const auto count = static_cast<std::uint32_t>(random_.below(3));
    leaf.set(count, static_cast<Side>(random_.below(4)));
    for (std::uint32_t i = 0; i < count; ++i) block.entries.push_back(Entry::of_group(i, 0.5 * i, 0xff));
    block.leaves.push_back(leaf);
  }

  Random& random_;
  int deepest_;
  double chance_;
  Octree tree_;
  std::vector<TreeNode> top_;
  std::vector<Block> blocks_;
};

}  // namespace cdfr::test
