/// One step of the level-by-level propagation: from a cell's complete list to its children's.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "cdfr/octree/options.h"
#include "geometry/sample_distances.h"
#include "octree/blocks.h"
#include "octree/influence.h"
#include "octree/key.h"
#include "octree/lattice.h"
#include "octree/search.h"

namespace cdfr {

/// A BVH node in the list of a cell under construction, most often a group.
struct Candidate {
  std::uint32_t node;
  float distance;  ///< of its kept triangles from the cell's centre as an Entry has it
  EntryBound bound;
  std::uint8_t lanes;  ///< triangles of a group that may win; all of them for larger nodes
};

/// A cell under construction. Its list is complete (influence.h), in the BVH's order.
struct OpenCell {
  Cell cell;
  std::vector<Candidate> list;
  Dominators dominators{};
  std::uint64_t triangles = 0;  ///< kept, under all candidates
};

struct RefineOptions {
  Lists lists = Lists::corner;
  /// Lists of up to this many triangles are taken apart to single triangles. Above it, nodes smaller than a
  /// quarter of the child's edge stay whole: opening them would cost much and drop little.
  std::uint64_t open_below = 1024;
};

/// What one refinement after another works with, so that none has to allocate it anew.
struct RefineScratch {
  std::vector<Candidate> groups;           ///< of a list that is taken apart
  std::vector<SampleDistances> distances;  ///< theirs
  NearestOfSamples nearest;
  std::array<CornerDominance, 8> rules;
  std::array<std::vector<Candidate>, 8> lists;
};

/// The virtual cube with everything in its list.
OpenCell root_cell(SearchSpace space);

/// The eight children with their lists; a child outside the brick gets an empty one. Runs alone, allocates
/// lists only.
std::array<OpenCell, 8> refine(SearchSpace space, const Lattice& lattice, const OpenCell& parent,
                               const RefineOptions& options, RefineScratch& scratch);

}  // namespace cdfr
