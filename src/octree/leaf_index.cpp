#include "octree/leaf_index.h"

#include <algorithm>
#include <bit>
#include <cmath>

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
  Maker(LeafIndex& index, const Octree& tree) : index_(index), tree_(tree) {}

  void run() {
    choose_grid();
    cover(Cell{}, entered({&tree_.top, tree_.top[0], 0}));
    index_.nodes_.shrink_to_fit();
  }

 private:
  /// A node of the top tree or of a block whose leaves are numbered from first_leaf on.
  struct At {
    const std::vector<TreeNode>* nodes;
    TreeNode node;
    std::uint32_t first_leaf;
  };

  /// About as many cells as leaves, so that the grid takes a fraction of their memory.
  void choose_grid() {
    std::size_t leaves = 0;
    for (const Block& block : tree_.blocks) leaves += block.leaves.size();
    const auto& bricks = tree_.lattice.bricks;
    const std::size_t cubes = std::size_t{bricks[0]} * bricks[1] * bricks[2];
    int& level = index_.grid_level_;
    while (level < deepest_level && cubes << (3 * (level + 1)) <= std::min(leaves, most_cells)) ++level;
    for (int axis = 0; axis < 3; ++axis) index_.cells_[axis] = bricks[axis] << level;
    index_.grid_.resize(cubes << (3 * level));
    index_.leaves_.reserve(leaves);
  }

  bool in_no_block(const At& at) const noexcept {
    return at.nodes == &tree_.top && at.node.is_leaf() && at.node.leaf_number() == Octree::no_block;
  }

  /// From a leaf of the top tree to the root of its block. Blocks are entered once each, in order.
  At entered(const At& at) {
    if (at.nodes != &tree_.top || !at.node.is_leaf() || in_no_block(at)) return at;
    const Block& block = tree_.blocks[at.node.leaf_number()];
    const auto first = static_cast<std::uint32_t>(index_.leaves_.size());
    for (const LeafRecord& leaf : block.leaves) {
      index_.leaves_.push_back({block.entries.data() + leaf.first, leaf.count_and_side, 0});
    }
    return {&block.nodes, block.nodes[0], first};
  }

  At child(const At& at, std::uint32_t number) {
    return entered({at.nodes, (*at.nodes)[at.node.first_child() + number], at.first_leaf});
  }

  void cover(const Cell& cell, const At& at) {
    if (in_no_block(at)) return;
    if (cell.level < index_.grid_level_ && !at.node.is_leaf()) {
      for (std::uint32_t i = 0; i < 8; ++i) cover(child_of(cell, static_cast<int>(i)), child(at, i));
      return;
    }
    const TreeNode node = copied(at, cell.level);
    const int up = index_.grid_level_ - cell.level;
    const auto [nx, ny, nz] = index_.cells_;
    const std::uint32_t wide = 1U << up;
    const auto x = cell.place[0] << up, y = cell.place[1] << up, z = cell.place[2] << up;
    for (std::uint32_t row = 0; row < wide * wide; ++row) {
      const std::size_t first = (std::size_t{z + row / wide} * ny + y + row % wide) * nx + x;
      std::fill_n(index_.grid_.begin() + static_cast<std::ptrdiff_t>(first), wide, node);
    }
  }

  TreeNode copied(const At& at, int level) {
    if (at.node.is_leaf()) {
      const std::uint32_t leaf = at.first_leaf + at.node.leaf_number();
      index_.leaves_[leaf].level = static_cast<std::uint32_t>(level);
      return TreeNode::leaf(leaf);
    }
    const auto first = static_cast<std::uint32_t>(index_.nodes_.size());
    index_.nodes_.resize(first + 8);
    for (std::uint32_t i = 0; i < 8; ++i) index_.nodes_[first + i] = copied(child(at, i), level + 1);
    return TreeNode::inner(first);
  }

  LeafIndex& index_;
  const Octree& tree_;
};

LeafIndex::LeafIndex(const Octree& tree) : origin_(tree.lattice.origin), scale_(1 / tree.lattice.edge) {
  if (tree.blocks.empty()) return;
  domain_ = tree.lattice.domain();
  Maker(*this, tree).run();
}

void LeafIndex::take_sides(const Octree& tree) noexcept {
  std::size_t i = 0;
  for (const Block& block : tree.blocks) {
    for (const LeafRecord& leaf : block.leaves) leaves_[i++].count_and_side = leaf.count_and_side;
  }
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
  TreeNode node = grid_[(std::size_t{z >> bit} * cells_[1] + (y >> bit)) * cells_[0] + (x >> bit)];
  while (!node.is_leaf()) {
    --bit;
    const std::uint32_t child = (x >> bit & 1U) | (y >> bit & 1U) << 1 | (z >> bit & 1U) << 2;
    node = nodes_[node.first_child() + child];
  }
  return node.leaf_number();
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
  return {{leaf.entries, record.count()},
          record.side(),
          {x, y, z},
          // A point that its own difference to the origin has moved by up to 2^-50 edges.
          std::sqrt(x * x + y * y + z * z) * (1 + 8 * unit_roundoff) + 0x1p-49,
          size};
}

std::uint64_t LeafIndex::bytes() const noexcept {
  return grid_.capacity() * sizeof(TreeNode) + nodes_.capacity() * sizeof(TreeNode) +
         leaves_.capacity() * sizeof(Leaf);
}

}  // namespace cdfr
