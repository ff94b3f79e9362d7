#include "field/finished_block.h"

#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include <memory>
#include <utility>

#include "field/block_sides.h"
#include "field/build_field.h"

namespace cdfr {
namespace {

/// Queries at points of the block are answered by the block itself. Its arrays are shared, so sides set here
/// are set there.
void finish(const FieldData& field, FinishedBlock& finished, Progress& progress) {
  FieldData own = field;
  own.tree = alone(field.tree.lattice, finished.block);
  own.index = LeafIndex(own.tree);
  set_sides(own, finished.block, progress);
  if (field.sign != Sign::winding || progress.cancelled()) return;
  own.index = LeafIndex(own.tree);  // with the sides
  finished.windings = block_windings(own);
}

template <class T>
void append(std::vector<T>& all, const std::vector<T>& part) {
  all.insert(all.end(), part.begin(), part.end());
}

}  // namespace

FinishedBlock finished_block(const FieldData& field, BlockCut& cut, std::size_t number, Progress& progress) {
  FinishedBlock finished;
  BuiltBlock built = cut.build(number);
  if (progress.cancelled()) return finished;
  finished.block = std::move(built.block);
  finished.levels = std::move(built.levels);
  finish(field, finished, progress);
  return finished;
}

Result<void> finish_blocks(const FieldData& field, BlockCut& cut, std::size_t first, Progress& progress,
                           const BlockSink& sink) {
  if (progress.cancelled()) return Progress::error();
  progress.phase(0.2, 1, static_cast<double>(cut.size() - first));
  Result<void> given;
  std::size_t next = first;
  const auto tokens = 2 * static_cast<std::size_t>(tbb::this_task_arena::max_concurrency());
  const auto number = [&](tbb::flow_control& control) {
    if (next == cut.size() || !given || progress.cancelled()) control.stop();
    return next++;
  };
  const auto build = [&](std::size_t i) {
    return std::make_shared<FinishedBlock>(finished_block(field, cut, i, progress));
  };
  const auto give = [&](const std::shared_ptr<FinishedBlock>& finished) {
    if (!given || progress.cancelled()) return;
    given = sink(std::move(*finished));
    progress.step();
  };
  using Shared = std::shared_ptr<FinishedBlock>;
  tbb::parallel_pipeline(tokens,
                         tbb::make_filter<void, std::size_t>(tbb::filter_mode::serial_in_order, number) &
                             tbb::make_filter<std::size_t, Shared>(tbb::filter_mode::parallel, build) &
                             tbb::make_filter<Shared, void>(tbb::filter_mode::serial_in_order, give));
  if (progress.cancelled()) return Progress::error();
  return given;
}

void take_blocks(FieldData& field, Octree upper, std::vector<FinishedBlock> blocks) {
  std::vector<Block> bare;
  LeafWindingLists windings;
  for (FinishedBlock& finished : blocks) {
    add_levels(upper.levels, finished.levels);
    move_behind(finished.windings, windings.known.size(), windings.near.size());
    append(windings.whole, finished.windings.whole);
    append(windings.place, finished.windings.place);
    append(windings.known, finished.windings.known);
    append(windings.near, finished.windings.near);
    bare.push_back(std::move(finished.block));
    finished = {};
  }
  join(upper, std::move(bare));
  field.tree = std::move(upper);
  field.index = LeafIndex(field.tree);
  field.leaf_windings = leaf_windings(std::move(windings));
}

}  // namespace cdfr
