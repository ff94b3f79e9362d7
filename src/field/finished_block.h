/// From the octree's upper part to blocks whose leaves know all that they should.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "cdfr/core/result.h"
#include "core/progress.h"
#include "field/field_data.h"
#include "field/leaf_winding.h"
#include "octree/build.h"

namespace cdfr {

struct FinishedBlock {
  Block block;  ///< with sides
  std::vector<LevelStats> levels;
  LeafWindingLists windings;  ///< as if there were no other block
};

/// Takes finished blocks, one at a time, in Morton order.
using BlockSink = std::function<Result<void>(FinishedBlock)>;

/// Thread safe. Incomplete if cancelled.
FinishedBlock finished_block(const FieldData& field, BlockCut& cut, std::size_t number, Progress& progress);

/// Builds the blocks from `first` on and gives them away. The field has everything but the octree; its
/// lattice is laid. No more blocks are in memory than twice the workers: a fast one waits for the sink. Runs
/// in the caller's task arena. Errors: the sink's, which end the work; cancelled.
Result<void> finish_blocks(const FieldData& field, BlockCut& cut, std::size_t first, Progress& progress,
                           const BlockSink& sink);

/// Makes the field's octree of all blocks.
void take_blocks(FieldData& field, Octree upper, std::vector<FinishedBlock> blocks);

}  // namespace cdfr
