#include "octree/leaf_index.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <utility>
#include <vector>

#include "geometry/double_double.h"

namespace cdfr {
namespace {

/// A grid that a second-level cache holds.
constexpr std::size_t most_cells = std::size_t{1} << 17;

/// 2^-k exactly.
double power_below(std::uint32_t k) noexcept { return std::bit_cast<double>(std::uint64_t{1023 - k} << 52); }

}  // namespace

/// Copies the octree's nodes, top and blocks, into one array with one numbering of leaves.
class LeafIndex::Maker {
 public:
  Maker(const Octree& tree, const Scratch* scratch)
      : tree_(tree), grid_(scratch), nodes_(scratch), leaves_(scratch) {}

  Tables made() {
    choose_grid();
    cover(Cell{}, entered({tree_.top.data(), tree_.top[0], 0}));
    return {grid_level_, std::move(grid_), std::move(nodes_), std::move(leaves_)};
  }

 private:
  /// A node of the top tree or of a block whose leaves are numbered from first_leaf on.
  struct At {
    const TreeNode* nodes;
    TreeNode node;
    std::uint32_t first_leaf;
  };

  /// About as many cells as leaves, so that the grid takes a fraction of their memory.
  void choose_grid() {
    const auto& bricks = tree_.lattice.bricks;
    const std::size_t cubes = std::size_t{bricks[0]} * bricks[1] * bricks[2];
    const std::size_t most = std::min(tree_.leaves.size(), most_cells);
    while (grid_level_ < deepest_level && cubes << (3 * (grid_level_ + 1)) <= most) ++grid_level_;
    grid_.resize(cubes << (3 * grid_level_));
    leaves_.reserve(tree_.leaves.size());
    nodes_.reserve(tree_.nodes.size());  // more only by what is above the grid
  }

  bool in_no_block(const At& at) const noexcept {
    return at.nodes == tree_.top.data() && at.node.is_leaf() && at.node.leaf_number() == Octree::no_block;
  }

  /// From a leaf of the top tree to the root of its block. Blocks are entered once each, in order.
  At entered(const At& at) {
    if (at.nodes != tree_.top.data() || !at.node.is_leaf() || in_no_block(at)) return at;
    const Block block = tree_.block(at.node.leaf_number());
    const auto first = static_cast<std::uint32_t>(leaves_.size());
    for (const LeafRecord& leaf : block.leaves)
      leaves_.push_back({first_entry_ + leaf.first, leaf.count_and_side, 0});
    first_entry_ += block.entries.size();
    return {block.nodes.data(), block.nodes[0], first};
  }

  At child(const At& at, std::uint32_t number) {
    return entered({at.nodes, at.nodes[at.node.first_child() + number], at.first_leaf});
  }

  void cover(const Cell& cell, const At& at) {
    if (in_no_block(at)) return;
    if (cell.level < grid_level_ && !at.node.is_leaf()) {
      for (std::uint32_t i = 0; i < 8; ++i) cover(child_of(cell, static_cast<int>(i)), child(at, i));
      return;
    }
    const TreeNode node = copied(at, cell.level);
    const int up = grid_level_ - cell.level;
    const auto nx = std::size_t{tree_.lattice.bricks[0]} << grid_level_;
    const auto ny = std::size_t{tree_.lattice.bricks[1]} << grid_level_;
    const std::uint32_t wide = 1U << up;
    const auto x = cell.place[0] << up, y = cell.place[1] << up, z = cell.place[2] << up;
    for (std::uint32_t row = 0; row < wide * wide; ++row) {
      const std::size_t first = (std::size_t{z + row / wide} * ny + y + row % wide) * nx + x;
      std::fill_n(grid_.begin() + static_cast<std::ptrdiff_t>(first), wide, node);
    }
  }

  TreeNode copied(const At& at, int level) {
    if (in_no_block(at)) return {};  // of an octree of one block
    if (at.node.is_leaf()) {
      const std::uint32_t leaf = at.first_leaf + at.node.leaf_number();
      leaves_[leaf].level = static_cast<std::uint32_t>(level);
      return TreeNode::leaf(leaf);
    }
    const auto first = static_cast<std::uint32_t>(nodes_.size());
    nodes_.resize(first + 8);
    for (std::uint32_t i = 0; i < 8; ++i) nodes_[first + i] = copied(child(at, i), level + 1);
    return TreeNode::inner(first);
  }

  const Octree& tree_;
  int grid_level_ = 0;
  Large<TreeNode> grid_, nodes_;
  Large<Leaf> leaves_;
  std::uint64_t first_entry_ = 0;
};

LeafIndex::LeafIndex(const Octree& tree, const Scratch* scratch)
    : LeafIndex(tree, tree.block_count() == 0 ? Tables{} : Maker(tree, scratch).made()) {}

LeafIndex::LeafIndex(const Octree& tree, Tables tables)
    : origin_(tree.lattice.origin), scale_(1 / tree.lattice.edge), tables_(std::move(tables)) {
  if (tree.block_count() == 0) return;
  domain_ = tree.block_count() == 1 ? tree.lattice.box(cell_of(tree.starts[0].key)) : tree.lattice.domain();
  grid_level_ = tables_.grid_level;
  for (int axis = 0; axis < 3; ++axis) cells_[axis] = tree.lattice.bricks[axis] << grid_level_;
  leaf_count_ = tables_.leaves.size();
  all_entries_ = tree.entries;
  grid_ = tables_.grid.data();
  nodes_ = tables_.nodes.data();
  leaves_ = tables_.leaves.data();
  entries_ = all_entries_.data();
}

/// x - origin rounds to nearest and so may reach the next lattice point from below by at most half an ulp:
/// cells are complete beyond that (Lattice::grown). Past the last cell there is none: p is in the brick. The
/// products are exact: powers of two.
LatticePoint LeafIndex::place(const Vec3& p) const noexcept {
  LatticePoint point;
  point.at = {(p.x - origin_.x) * scale_, (p.y - origin_.y) * scale_, (p.z - origin_.z) * scale_};
  const double at[3] = {point.at.x, point.at.y, point.at.z};
  for (int axis = 0; axis < 3; ++axis) {
    const std::uint32_t most = (cells_[axis] << (deepest_level - grid_level_)) - 1;
    point.place[axis] = std::min(static_cast<std::uint32_t>(at[axis] * (1U << deepest_level)), most);
  }
  return point;
}

std::uint32_t LeafIndex::leaf(const LatticePoint& point) const noexcept {
  const auto [x, y, z] = point.place;
  int bit = deepest_level - grid_level_;
  assert(bit >= 0);
  TreeNode node = grid_[(std::size_t{z >> bit} * cells_[1] + (y >> bit)) * cells_[0] + (x >> bit)];
  while (!node.is_leaf() && bit > 0) {  // in a forged file there may be no end
    --bit;
    const std::uint32_t child = (x >> bit & 1U) | (y >> bit & 1U) << 1 | (z >> bit & 1U) << 2;
    node = nodes_[node.first_child() + child];
  }
  return node.is_leaf() ? node.leaf_number() : 0;
}

Located LeafIndex::at(const LatticePoint& point, std::uint32_t number) const noexcept {
  const Leaf& leaf = leaves_[number];
  const std::uint32_t up = static_cast<std::uint32_t>(deepest_level) - leaf.level;
  const double size = power_below(leaf.level);
  const auto from_middle = [&](double at, std::uint32_t place) noexcept {
    return at - ((place >> up) + 0.5) * size;
  };
  const double x = from_middle(point.at.x, point.place[0]);
  const double y = from_middle(point.at.y, point.place[1]);
  const double z = from_middle(point.at.z, point.place[2]);
  const LeafRecord record{0, leaf.count_and_side};
  return {{entries_ + leaf.first, record.count()},
          record.side(),
          {x, y, z},
          // A point that its own difference to the origin has moved by up to 2^-50 edges.
          std::sqrt(x * x + y * y + z * z) * (1 + 8 * unit_roundoff) + 0x1p-49,
          size};
}

std::uint64_t LeafIndex::bytes() const noexcept {
  return tables_.grid.bytes() + tables_.nodes.bytes() + tables_.leaves.bytes();
}

}  // namespace cdfr
