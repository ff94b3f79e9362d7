/// The leaves of a field's octree, as a caller sees them, and counts of its levels.
#pragma once

#include <cstdint>
#include <vector>

#include "cdfr/core/types.h"

namespace cdfr {

/// Which side of the surface a leaf is on. `undecided`: no triangle comes in, but the mesh is open and all of
/// the leaf could not be shown to be on one side.
enum class Side : std::uint8_t { outside, surface, inside, undecided };

/// One leaf of the octree. `triangles` are numbers in the input, ascending.
struct Leaf {
  std::uint64_t key = 0;  ///< sentinel bit, then Morton order: see src/octree/key.h
  int level = 0;
  Box box;  ///< exact
  Side side = Side::surface;
  std::vector<std::uint32_t> triangles;
};

/// Counts of one octree level. `entries_in` is what the level's cells inherited, before pruning.
struct LevelStats {
  int level = 0;
  std::uint64_t cells = 0, leaves = 0;
  std::uint64_t entries_in = 0, entries_pruned = 0, entries_kept = 0;
  double mean_list = 0;  ///< triangles a leaf of this level
};

}  // namespace cdfr
