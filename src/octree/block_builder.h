/// One block of the octree, level by level.
#pragma once

#include <cstdint>
#include <vector>

#include "cdfr/octree/options.h"
#include "core/progress.h"
#include "octree/blocks.h"
#include "octree/refine.h"
#include "octree/search.h"

namespace cdfr {

/// A cell splits while its list is longer than the threshold, it is above the deepest level, and the split
/// pays: the mean list of the children is at most `gain` of its own. Where two walls are equally far a split
/// halves half of the lists for ever, so there is a limit to the block's leaves too; what is left of it goes
/// to the longest lists. Working memory is one level's lists.
class BlockBuilder {
 public:
  BlockBuilder(SearchSpace space, const Lattice& lattice, const BuildOptions& options,
               const RefineOptions& refining, RefineScratch& scratch, std::uint64_t most_leaves,
               Progress& progress)
      : space_(space),
        lattice_(lattice),
        options_(options),
        refining_(refining),
        scratch_(scratch),
        most_leaves_(most_leaves),
        progress_(progress) {}

  /// `inherited` counts the triangles that the root's list was pruned from.
  Block build(OpenCell root, std::uint64_t inherited);
  const std::vector<LevelStats>& levels() const noexcept { return levels_; }

 private:
  struct Growing {
    OpenCell open;
    std::uint32_t node;
  };

  bool may_split(const OpenCell& cell) const noexcept;
  bool pays(const OpenCell& cell, const std::array<OpenCell, 8>& children) const noexcept;
  void count(const OpenCell& cell, std::uint64_t inherited);
  void close(Growing&& cell);
  std::vector<Entry> listed(const std::vector<Candidate>& candidates) const;
  bool may_cross(const OpenCell& cell) const;
  Block laid_out(std::uint64_t key);

  SearchSpace space_;
  const Lattice& lattice_;
  const BuildOptions& options_;
  const RefineOptions& refining_;
  RefineScratch& scratch_;
  std::uint64_t most_leaves_;
  Progress& progress_;
  std::vector<TreeNode> nodes_;
  std::vector<std::vector<Entry>> lists_;  ///< of closed cells, in the order they closed
  std::vector<bool> crossed_;
  std::vector<LevelStats> levels_;
};

}  // namespace cdfr
