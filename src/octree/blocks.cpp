#include "octree/blocks.h"

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

/// Takes the next `count` values; false if there are fewer.
template <class T>
bool take(const Array<T>& all, std::uint64_t& from, std::uint64_t count, Array<T>& part) {
  if (count > all.size() - from) return false;
  part = all.part(from, count);
  from += count;
  return true;
}

}  // namespace

bool divide(Octree& tree, std::span<const BlockSize> sizes) {
  std::uint64_t node = 0, leaf = 0, entry = 0;
  tree.blocks.assign(sizes.size(), {});
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    Block& block = tree.blocks[i];
    block.key = sizes[i].key;
    if (!take(tree.nodes, node, sizes[i].nodes, block.nodes) ||
        !take(tree.leaves, leaf, sizes[i].leaves, block.leaves) ||
        !take(tree.entries, entry, sizes[i].entries, block.entries)) {
      return false;
    }
  }
  return node == tree.nodes.size() && leaf == tree.leaves.size() && entry == tree.entries.size();
}

std::vector<BlockSize> sizes_of(const Octree& tree) {
  std::vector<BlockSize> sizes;
  for (const Block& b : tree.blocks)
    sizes.push_back({b.key, b.nodes.size(), b.leaves.size(), b.entries.size()});
  return sizes;
}

void join(Octree& tree, std::vector<Block> blocks) {
  tree.blocks = std::move(blocks);
  const std::vector<BlockSize> sizes = sizes_of(tree);
  tree.nodes = joined(tree.blocks, &Block::nodes);
  tree.leaves = joined(tree.blocks, &Block::leaves);
  tree.entries = joined(tree.blocks, &Block::entries);
  divide(tree, sizes);
}

Octree alone(const Lattice& lattice, const Block& block) {
  Octree tree;
  tree.lattice = lattice;
  tree.nodes = block.nodes;
  tree.leaves = block.leaves;
  tree.entries = block.entries;
  tree.blocks = {block};
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
