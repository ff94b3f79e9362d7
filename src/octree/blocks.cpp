#include "octree/blocks.h"

#include <algorithm>
#include <utility>

namespace cdfr {
namespace {

template <class T>
Array<T> joined(std::vector<Block>& blocks, Array<T> Block::*part) {
  std::size_t size = 0;
  for (const Block& block : blocks) size += (block.*part).size();
  std::vector<T> all;
  all.reserve(size);
  for (Block& block : blocks) {
    all.insert(all.end(), (block.*part).begin(), (block.*part).end());
    block.*part = {};
  }
  return all;
}

/// False if they are not all there.
template <class T>
bool take(const Array<T>& all, std::uint64_t first, std::uint64_t end, Array<T>& part) {
  if (first > end || end > all.size()) return false;
  part = all.part(first, end - first);
  return true;
}

Block single_leaf(std::uint64_t key) {
  return {key, std::vector{TreeNode::leaf(0)}, std::vector{LeafRecord{0, 1U << 2}},
          std::vector{Entry::of_group(0, 0, 1)}};
}

}  // namespace

Block Octree::block(std::size_t number) const {
  const BlockStart from = starts[number], to = starts[number + 1];
  Block block;
  block.key = from.key;
  const bool whole = take(nodes, from.node, to.node, block.nodes) &&
                     take(leaves, from.leaf, to.leaf, block.leaves) &&
                     take(entries, from.entry, to.entry, block.entries);
  return whole && !block.nodes.empty() && !block.leaves.empty() ? block : single_leaf(from.key);
}

std::size_t Octree::block_of_leaf(std::uint64_t leaf) const noexcept {
  const auto begins_behind = [](std::uint64_t i, const BlockStart& start) { return i < start.leaf; };
  const auto last = starts.end() - 1;
  return static_cast<std::size_t>(std::upper_bound(starts.begin() + 1, last, leaf, begins_behind) -
                                  starts.begin() - 1);
}

void join(Octree& tree, std::vector<Block> blocks) {
  std::vector<BlockStart> starts(1);
  for (const Block& block : blocks) {
    starts.back().key = block.key;
    starts.push_back(starts.back().next(block.nodes.size(), block.leaves.size(), block.entries.size()));
  }
  tree.starts = std::move(starts);
  tree.nodes = joined(blocks, &Block::nodes);
  tree.leaves = joined(blocks, &Block::leaves);
  tree.entries = joined(blocks, &Block::entries);
}

Octree alone(const Lattice& lattice, const Block& block) {
  Octree tree;
  tree.lattice = lattice;
  tree.nodes = block.nodes;
  tree.leaves = block.leaves;
  tree.entries = block.entries;
  tree.starts = std::vector{BlockStart{block.key},
                            BlockStart{}.next(block.nodes.size(), block.leaves.size(), block.entries.size())};
  const Cell root = cell_of(block.key);
  std::vector<TreeNode> top(1);
  std::size_t at = 0;
  for (int level = Cell{}.level; level < root.level; ++level) {
    const std::size_t first = top.size();
    top[at] = TreeNode::inner(static_cast<std::uint32_t>(first));
    top.resize(first + 8, TreeNode::leaf(Octree::no_block));
    std::size_t child = 0;
    const int up = root.level - level - 1;
    for (int axis = 0; axis < 3; ++axis) child |= std::size_t{root.place[axis] >> up & 1U} << axis;
    at = first + child;
  }
  top[at] = TreeNode::leaf(0);
  tree.top = std::move(top);
  return tree;
}

}  // namespace cdfr
