/// One step of the level-by-level propagation: from a cell's complete list to its children's.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "cdfr/octree/options.h"
#include "octree/blocks.h"
#include "octree/influence.h"
#include "octree/key.h"
#include "octree/lattice.h"
#include "octree/search.h"

namespace cdfr {

/// A cell under construction. Its list is complete (influence.h), ascending by a lower bound on the distance
/// from the centre.
struct OpenCell {
  Cell cell;
  std::vector<Entry> list;
  Dominators dominators{};
  std::uint64_t triangles = 0;  ///< kept, under all entries
};

struct RefineOptions {
  Lists lists = Lists::corner;
  /// Lists of up to this many triangles are taken apart to single triangles. Above it, nodes smaller than a
  /// quarter of the child's edge stay whole: opening them would cost much and drop little.
  std::uint64_t open_below = 1024;
};

/// The virtual cube with everything in its list.
OpenCell root_cell(SearchSpace space);

/// The eight children with their lists; a child outside the brick gets an empty one. Runs alone, allocates
/// lists only.
std::array<OpenCell, 8> refine(SearchSpace space, const Lattice& lattice, const OpenCell& parent,
                               const RefineOptions& options);

}  // namespace cdfr
