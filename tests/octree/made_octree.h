/// Octrees made at random, with no mesh behind them: every depth of blocks and leaves comes up.
#pragma once

#include <cstdint>

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
    tree_.top.resize(1);
  }

  Octree made() {
    cut({}, 0);
    return std::move(tree_);
  }

 private:
  bool splits(const Cell& cell) { return cell.level < deepest_ && random_.between(0, 1) < chance_; }

  void cut(const Cell& cell, std::size_t at) {
    if (!tree_.lattice.meets_brick(cell)) {
      tree_.top[at] = TreeNode::leaf(Octree::no_block);
    } else if (cell.level >= 0 && (cell.level == block_deepest || !splits(cell))) {
      tree_.top[at] = TreeNode::leaf(static_cast<std::uint32_t>(tree_.blocks.size()));
      Block block;
      block.key = key_of(cell);
      block.nodes.resize(1);
      grow(block, cell, 0);
      tree_.blocks.push_back(std::move(block));
    } else {
      const std::size_t first = tree_.top.size();
      tree_.top[at] = TreeNode::inner(static_cast<std::uint32_t>(first));
      tree_.top.resize(first + 8);
      for (int i = 0; i < 8; ++i) cut(child_of(cell, i), first + static_cast<std::size_t>(i));
    }
  }

  void grow(Block& block, const Cell& cell, std::size_t at) {
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
};

}  // namespace cdfr::test
