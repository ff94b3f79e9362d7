#include "octree/cut.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/vector.h"
#include "octree/search.h"

namespace cdfr {
namespace {

class Cutter {
 public:
  Cutter(const Octree& tree, const Bvh& bvh, int level) : tree_(tree), bvh_(bvh), level_(level) {}

  CutOctree cut() {
    top_.resize(1);
    walk({}, {tree_.top.data(), tree_.top[0], nullptr, 0}, 0);
    CutOctree cut;
    cut.tree.lattice = tree_.lattice;
    cut.tree.top = std::move(top_);
    cut.tree.levels = cut_levels();
    join(cut.tree, std::move(blocks_));
    cut.source = std::move(source_);
    return cut;
  }

 private:
  /// A node of the top tree, or of a block that begins at that leaf.
  struct At {
    const TreeNode* nodes;
    TreeNode node;
    const Block* block;
    std::uint64_t first_leaf;

    At child(int i) const noexcept {
      return {nodes, nodes[node.first_child() + static_cast<std::uint32_t>(i)], block, first_leaf};
    }
  };
  struct Growing {
    std::vector<TreeNode> nodes;
    std::vector<LeafRecord> leaves;
    std::vector<Entry> entries;
  };
  /// What a leaf is made of.
  struct Parts {
    Cell cell;
    std::vector<Entry> entries;
    std::array<bool, 4> sides{};
    std::size_t count = 0;
    std::uint64_t leaf = 0;  ///< the last one
  };

  /// Enters the block at a leaf of the top tree; it stays until the next one is entered.
  At entered(const At& at) {
    if (at.block != nullptr || !at.node.is_leaf() || at.node.leaf_number() == Octree::no_block) return at;
    const std::uint32_t number = at.node.leaf_number();
    block_ = tree_.block(number);
    return {block_.nodes.data(), block_.nodes[0], &block_, tree_.starts[number].leaf};
  }

  void walk(const Cell& cell, const At& at, std::size_t top) {
    if (at.node.is_leaf() && at.node.leaf_number() == Octree::no_block) {
      top_[top] = at.node;
    } else if (cell.level == level_ || at.node.is_leaf()) {
      top_[top] = TreeNode::leaf(static_cast<std::uint32_t>(blocks_.size()));
      Growing block;
      block.nodes.resize(1);
      grow(block, cell, entered(at), 0);
      blocks_.push_back(
          {key_of(cell), std::move(block.nodes), std::move(block.leaves), std::move(block.entries)});
    } else {
      const std::size_t first = top_.size();
      top_[top] = TreeNode::inner(static_cast<std::uint32_t>(first));
      top_.resize(first + 8);
      for (int i = 0; i < 8; ++i) walk(child_of(cell, i), at.child(i), first + static_cast<std::size_t>(i));
    }
  }

  void grow(Growing& block, const Cell& cell, const At& at, std::size_t node) {
    if (cell.level < level_ && !at.node.is_leaf()) {
      const std::size_t first = block.nodes.size();
      block.nodes[node] = TreeNode::inner(static_cast<std::uint32_t>(first));
      block.nodes.resize(first + 8);
      for (int i = 0; i < 8; ++i)
        grow(block, child_of(cell, i), at.child(i), first + static_cast<std::size_t>(i));
      return;
    }
    block.nodes[node] = TreeNode::leaf(static_cast<std::uint32_t>(block.leaves.size()));
    Parts parts{cell, {}};
    gather(cell, at, parts);
    add_leaf(block, parts);
  }

  void gather(const Cell& cell, const At& before, Parts& parts) {
    const At at = entered(before);
    if (!at.node.is_leaf()) {
      for (int i = 0; i < 8; ++i) gather(child_of(cell, i), at.child(i), parts);
      return;
    }
    if (at.block == nullptr) return;  // no cell of the brick
    const LeafRecord& leaf = at.block->leaves[at.node.leaf_number()];
    parts.sides[static_cast<std::size_t>(leaf.side())] = true;
    parts.leaf = at.first_leaf + at.node.leaf_number();
    const bool is_whole = cell == parts.cell;
    const Vec3 a = tree_.lattice.centre(cell), b = tree_.lattice.centre(parts.cell);
    const double apart = (to_eigen(a) - to_eigen(b)).norm() / tree_.lattice.edge * (1 + 0x1p-50);
    for (std::uint32_t i = leaf.first; i < leaf.first + leaf.count(); ++i) {
      const Entry& entry = at.block->entries[i];
      const double distance = std::max(0.0, entry.distance() - apart);
      parts.entries.push_back(is_whole           ? entry
                              : entry.is_group() ? Entry::of_group(entry.number(), distance, entry.lanes())
                                                 : Entry::of_node(entry.number(), distance));
    }
    ++parts.count;
  }

  void add_leaf(Growing& block, Parts& parts) {
    if (parts.count > 1) parts.entries = united(std::move(parts.entries));
    LeafRecord record{static_cast<std::uint32_t>(block.entries.size()), 0};
    record.set(static_cast<std::uint32_t>(parts.entries.size()), side_of(parts.sides));
    block.entries.insert(block.entries.end(), parts.entries.begin(), parts.entries.end());
    block.leaves.push_back(record);
    source_.push_back(parts.count == 1 ? parts.leaf : CutOctree::no_leaf);
  }

  static Side side_of(const std::array<bool, 4>& sides) noexcept {
    const auto has = [&](Side side) { return sides[static_cast<std::size_t>(side)]; };
    if (has(Side::surface)) return Side::surface;
    if (has(Side::undecided) || (has(Side::inside) && has(Side::outside))) return Side::undecided;
    return has(Side::inside) ? Side::inside : Side::outside;
  }

  /// Each group and node once, by their groups: nodes before what is below them.
  std::vector<Entry> united(std::vector<Entry> entries) const {
    const auto before = [this](const Entry& a, const Entry& b) {
      const GroupRange x = groups_of(bvh_, a), y = groups_of(bvh_, b);
      if (x.first != y.first) return x.first < y.first;
      return x.end != y.end ? x.end > y.end : a.is_group() < b.is_group();
    };
    std::sort(entries.begin(), entries.end(), before);
    std::vector<Entry> kept;
    std::uint32_t covered = 0;  // groups below this are in nodes that are kept
    for (const Entry& entry : entries) {
      const GroupRange range = groups_of(bvh_, entry);
      if (!kept.empty() && kept.back().is_group() == entry.is_group() &&
          kept.back().number() == entry.number()) {
        kept.back() = joined(kept.back(), entry);
      } else if (range.first >= covered) {
        kept.push_back(entry);
        if (!entry.is_group()) covered = range.end;
      } else {
        // Below a node: that one's distance has to hold for this as well.
        Entry& node = *std::find_if(kept.rbegin(), kept.rend(), [](const Entry& e) { return !e.is_group(); });
        node = joined(node, entry);
      }
    }
    std::sort(kept.begin(), kept.end());
    return kept;
  }

  /// The first one, with the other's triangles in it.
  static Entry joined(const Entry& a, const Entry& b) noexcept {
    const double distance = std::min(a.distance(), b.distance());
    if (!a.is_group()) return Entry::of_node(a.number(), distance);
    return Entry::of_group(a.number(), distance, a.lanes() | b.lanes());
  }

  std::vector<LevelStats> cut_levels() const {
    std::vector<LevelStats> levels = tree_.levels;
    if (levels.size() <= static_cast<std::size_t>(level_)) return levels;
    levels.resize(static_cast<std::size_t>(level_) + 1);
    levels.back().leaves = levels.back().cells;
    return levels;
  }

  const Octree& tree_;
  const Bvh& bvh_;
  int level_;
  Block block_;
  std::vector<TreeNode> top_;
  std::vector<Block> blocks_;
  std::vector<std::uint64_t> source_;
};

}  // namespace

CutOctree cut_at(const Octree& tree, const Bvh& bvh, int level) { return Cutter(tree, bvh, level).cut(); }

}  // namespace cdfr
