/// From a point to its leaf in few dependent loads: a dense grid over the brick, then tables of eight
/// children. Derived from the octree, and not stored.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "cdfr/core/types.h"
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
  LeafIndex() = default;
  /// The octree's blocks must outlive the index and keep their arrays in place.
  explicit LeafIndex(const Octree& tree);

  /// Takes over the sides of the leaves, set since. The octree is the one that the index was made of.
  void take_sides(const Octree& tree) noexcept;

  bool empty() const noexcept { return leaves_.empty(); }
  /// The half-open brick, where the steps below answer; nothing if the octree has no blocks.
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
  struct Leaf {
    const Entry* entries;
    std::uint32_t count_and_side;
    std::uint32_t level;
  };

  class Maker;

  Vec3 origin_;
  Box domain_;
  double scale_ = 1;                      ///< edges in a unit of length
  std::array<std::uint32_t, 3> cells_{};  ///< of the grid, along each axis
  int grid_level_ = 0;
  std::vector<TreeNode> grid_;
  std::vector<TreeNode> nodes_;  ///< eight children each, below the grid's level
  std::vector<Leaf> leaves_;     ///< in Morton order
};

}  // namespace cdfr
