/// The octree as it is stored: blocks of pointer-free arrays, the same in memory and in a file.
#pragma once

#include <bit>
#include <cstdint>
#include <vector>

#include "cdfr/octree/leaf.h"
#include "core/array.h"
#include "octree/entry_bound.h"
#include "octree/key.h"
#include "octree/lattice.h"

namespace cdfr {

/// One CDD tuple of a leaf's influence list: a group of triangles, or a BVH node above several groups, and a
/// distance from the leaf's centre that none of its kept triangles goes below, in units of the lattice's
/// edge. Eight bits of the distance's mantissa give way to the lanes: bit i says that triangle i of the group
/// may win in this leaf. All lanes are set for nodes. `bound` says more of where in the leaf they are closer.
class Entry {
 public:
  Entry() = default;
  /// `distance` is rounded down.
  static Entry of_group(std::uint32_t group, double distance, std::uint8_t lanes,
                        EntryBound bound = {}) noexcept {
    return {group, distance, lanes, bound};
  }
  static Entry of_node(std::uint32_t node, double distance, EntryBound bound = {}) noexcept {
    return {node | node_bit, distance, 0xff, bound};
  }
  /// The distance as an entry keeps it.
  static float kept(double distance) noexcept { return Entry(0, distance, 0, {}).distance(); }

  bool is_group() const noexcept { return (place_ & node_bit) == 0; }
  /// Of the group or of the node.
  std::uint32_t number() const noexcept { return place_ & ~node_bit; }
  std::uint8_t lanes() const noexcept { return static_cast<std::uint8_t>(packed_ & 0xffU); }
  float distance() const noexcept { return std::bit_cast<float>(packed_ & ~0xffU); }
  const EntryBound& bound() const noexcept { return bound_; }

  /// The order of a list.
  friend bool operator<(const Entry& a, const Entry& b) noexcept {
    return a.distance() != b.distance() ? a.distance() < b.distance() : a.place_ < b.place_;
  }

 private:
  static constexpr std::uint32_t node_bit = 0x80000000U;
  Entry(std::uint32_t place, double distance, std::uint8_t lanes, EntryBound bound) noexcept
      : place_(place), bound_(bound) {
    auto f = static_cast<float>(distance);
    auto bits = std::bit_cast<std::uint32_t>(f);
    if (bits != 0 && static_cast<double>(f) > distance) --bits;
    packed_ = (bits & ~0xffU) | lanes;
  }

  std::uint32_t place_ = 0;
  std::uint32_t packed_ = 0;
  EntryBound bound_;
};
static_assert(sizeof(Entry) == 12);

/// A leaf's list is entries[first] .. entries[first + count - 1] of its block, ascending as entries
/// compare.
struct LeafRecord {
  std::uint32_t first = 0;
  std::uint32_t count_and_side = 0;  ///< count * 4 + side

  std::uint32_t count() const noexcept { return count_and_side >> 2; }
  Side side() const noexcept { return static_cast<Side>(count_and_side & 3U); }
  void set(std::uint32_t count, Side side) noexcept {
    count_and_side = count << 2 | static_cast<std::uint32_t>(side);
  }
};

/// A node of a tree: a leaf's number, or the place of the first of its eight children in the same array.
class TreeNode {
 public:
  static TreeNode leaf(std::uint32_t number) noexcept { return TreeNode(number | leaf_bit); }
  static TreeNode inner(std::uint32_t first_child) noexcept { return TreeNode(first_child); }
  TreeNode() = default;

  bool is_leaf() const noexcept { return (word_ & leaf_bit) != 0; }
  std::uint32_t leaf_number() const noexcept { return word_ & ~leaf_bit; }
  std::uint32_t first_child() const noexcept { return word_; }

 private:
  static constexpr std::uint32_t leaf_bit = 0x80000000U;
  explicit TreeNode(std::uint32_t word) noexcept : word_(word) {}
  std::uint32_t word_ = leaf_bit;
};

/// A subtree on its own: nothing in it points outside but the entries' BVH nodes. nodes[0] is its root;
/// leaves are in Morton order.
struct Block {
  std::uint64_t key = 0;  ///< of the root cell
  Array<TreeNode> nodes;
  Array<LeafRecord> leaves;
  Array<Entry> entries;
};

/// Where a block begins in the octree's arrays.
struct BlockStart {
  std::uint64_t key = 0;
  std::uint64_t node = 0, leaf = 0, entry = 0;

  /// Where the next one begins, if this one has so many.
  BlockStart next(std::uint64_t nodes, std::uint64_t leaves, std::uint64_t entries) const noexcept {
    return {0, node + nodes, leaf + leaves, entry + entries};
  }
};

/// Blocks in Morton order, and the tree above them. The cut into blocks is a function of mesh and options
/// alone.
struct Octree {
  Lattice lattice;
  /// From the virtual cube down; a leaf's number is a block, or no_block where the brick has no cell.
  Array<TreeNode> top;
  /// Of all blocks, one after another.
  Array<TreeNode> nodes;
  Array<LeafRecord> leaves;
  Array<Entry> entries;
  /// Where each block begins, and where the last one ends. Empty without blocks.
  Array<BlockStart> starts;
  std::vector<LevelStats> levels;

  static constexpr std::uint32_t no_block = 0x7fffffffU;

  std::size_t block_count() const noexcept { return starts.empty() ? 0 : starts.size() - 1; }
  /// Its parts of the arrays above; of a forged file whose starts make no sense, one leaf.
  Block block(std::size_t number) const;
  /// The block that holds a leaf of the whole octree. O(log blocks).
  std::size_t block_of_leaf(std::uint64_t leaf) const noexcept;
};

/// Moves the arrays of blocks that were built on their own one after another; theirs are given up on the way.
void join(Octree& tree, std::vector<Block> blocks);
/// An octree of one block, the others missing.
Octree alone(const Lattice& lattice, const Block& block);

}  // namespace cdfr
