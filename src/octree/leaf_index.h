/// From a point to its leaf in few dependent loads: a dense grid over the brick, then tables of eight
/// children. Made of the octree once, and stored with it.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "cdfr/core/types.h"
#include "core/scratch.h"
#include "octree/blocks.h"

namespace cdfr {

/// A point in units of the lattice's edge, from the lattice's origin, and its place on the deepest level.
struct LatticePoint {
  Vec3 at;
  std::array<std::uint32_t, 3> place;
};

/// A leaf as a query at a point in it wants it.
struct Located {
  std::span<const Entry> entries;
  Side side = Side::undecided;
  Vec3 offset;             ///< of the point from the leaf's centre, in edges
  double from_centre = 0;  ///< its length, rounded up
  double size = 0;         ///< edge of the leaf, in edges of the lattice
};

class LeafIndex {
 public:
  struct Leaf {
    std::uint64_t first;  ///< of its entries, in all of the octree's
    std::uint32_t count_and_side;
    std::uint32_t level;
  };
  /// What the index is made of.
  struct Tables {
    int grid_level = 0;
    Array<TreeNode> grid;
    Array<TreeNode> nodes;  ///< eight children each, below the grid's level
    Array<Leaf> leaves;     ///< in Morton order
  };

  LeafIndex() = default;
  /// Of leaves whose sides are set. Shares the octree's entries; the tables lie in the scratch.
  explicit LeafIndex(const Octree& tree, const Scratch* scratch = nullptr);
  /// Of tables that were made from that octree before.
  LeafIndex(const Octree& tree, Tables tables);

  bool empty() const noexcept { return leaf_count_ == 0; }
  const Tables& tables() const noexcept { return tables_; }
  /// The half-open brick, where the steps below answer, or the cell of an octree's only block; nothing if it
  /// has none.
  bool contains(const Vec3& p) const noexcept {
    return p.x >= domain_.lo.x && p.x < domain_.hi.x && p.y >= domain_.lo.y && p.y < domain_.hi.y &&
           p.z >= domain_.lo.z && p.z < domain_.hi.z;
  }

  /// Three steps to the leaf whose half-open cell holds p; each reads what the one before has found, so that
  /// a caller with many points can let the reads overlap. Precondition: contains(p).
  LatticePoint place(const Vec3& p) const noexcept;
  std::uint32_t leaf(const LatticePoint& point) const noexcept;
  Located at(const LatticePoint& point, std::uint32_t leaf) const noexcept;

  const Box& domain() const noexcept { return domain_; }
  /// The leaf's cell is 2^up places wide.
  std::uint32_t up(std::uint32_t leaf) const noexcept {
    return static_cast<std::uint32_t>(deepest_level) - leaves_[leaf].level;
  }

  void prefetch(std::uint32_t leaf) const noexcept { __builtin_prefetch(&leaves_[leaf]); }
  std::uint64_t bytes() const noexcept;

 private:
  class Maker;

  Vec3 origin_;
  Box domain_;
  double scale_ = 1;                      ///< edges in a unit of length
  std::array<std::uint32_t, 3> cells_{};  ///< of the grid, along each axis
  int grid_level_ = 0;
  std::size_t leaf_count_ = 0;
  // Where the tables and the entries lie.
  const TreeNode* grid_ = nullptr;
  const TreeNode* nodes_ = nullptr;
  const Leaf* leaves_ = nullptr;
  const Entry* entries_ = nullptr;
  Tables tables_;
  Array<Entry> all_entries_;
};

}  // namespace cdfr
