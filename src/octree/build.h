/// The octree over a mesh: cut into blocks, then level by level inside each block.
#pragma once

#include <tbb/enumerable_thread_specific.h>

#include <cstdint>
#include <vector>

#include "cdfr/octree/options.h"
#include "core/progress.h"
#include "octree/block_builder.h"
#include "octree/blocks.h"
#include "octree/refine.h"
#include "octree/search.h"

namespace cdfr {

/// Cells of level 0 and deeper with at most this many triangles in their list become roots of blocks; so do
/// all of level block_deepest.
inline constexpr std::uint64_t block_triangles = 1U << 16;
inline constexpr int block_deepest = 6;

/// What the leaves may add up to, unless the gain test is off (BuildOptions::gain). With lists of m
/// triangles parts have 1000 to 2000 m^-1.5 leaves a triangle (list_length.cpp). Where many walls are equally
/// far there would be several times as many, at twice the memory, and queries would take as long.
inline constexpr double leaves_in_all = 1U << 11;
inline constexpr double leaves_a_triangle = 1700;  ///< times m^-1.5

/// A block and what its levels came to.
struct BuiltBlock {
  Block block;
  std::vector<LevelStats> levels;
};

/// The octree's upper part, and its blocks, each to be built on its own, in any order.
class BlockCut {
 public:
  /// Refines from the virtual cube down until lists are short enough for one block each. Runs in the caller's
  /// task arena. Of no use if the progress is cancelled. What is passed by reference must outlive this.
  /// Cells that `left_out` picks become leaves whose list is the whole BVH.
  BlockCut(SearchSpace space, const Lattice& lattice, const BuildOptions& options, Progress& progress,
           LeftOut left_out = {});

  /// Without blocks.
  Octree octree() const;
  std::size_t size() const noexcept { return seeds_.size(); }
  /// Triangles in the list of a block's root. Precondition: the block is not built yet.
  std::uint64_t listed(std::size_t number) const noexcept { return seeds_[number].open.triangles; }
  /// Each once. Leaves come out as `surface` where the surface may touch the closed cell, else as
  /// `undecided`: the field sets sides. Thread safe. Incomplete if cancelled. O(output).
  BuiltBlock build(std::size_t number);

 private:
  struct Seed {
    OpenCell open;
    std::uint64_t inherited = 0;  ///< triangles of the parent's list
  };
  using Scratches = tbb::enumerable_thread_specific<RefineScratch>;
  struct Pending;

  void cut();
  std::uint64_t most_leaves(const OpenCell& root) const noexcept;

  SearchSpace space_;
  const Lattice& lattice_;
  const BuildOptions& options_;
  RefineOptions refining_;
  Progress& progress_;
  LeftOut left_out_;
  Scratches scratches_;
  Array<TreeNode> top_;
  std::vector<Seed> seeds_;   ///< in Morton order
  std::uint64_t listed_ = 0;  ///< triangles of all seeds' lists
};

void add_levels(std::vector<LevelStats>& sum, const std::vector<LevelStats>& part);

}  // namespace cdfr
