/// A built octree cut at a level: what was deeper becomes one leaf of its cell.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/bvh.h"
#include "octree/blocks.h"

namespace cdfr {

struct CutOctree {
  Octree tree;
  /// By leaf: its number in the octree that was cut, or no_leaf if it is made of several.
  std::vector<std::uint64_t> source;

  static constexpr std::uint64_t no_leaf = ~std::uint64_t{0};
};

/// A leaf's list is the union of its parts' lists, so it is complete: each point of the cell lies in one of
/// them. The distance of an entry from the new centre is at least that from the part's centre less how far
/// the centres are apart. Groups below a BVH node that is in the list too are left to the node.
///
/// Precondition: level is 0 or more. O(what it reads).
CutOctree cut_at(const Octree& tree, const Bvh& bvh, int level);

}  // namespace cdfr
