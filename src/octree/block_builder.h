/// One block of the octree, level by level.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "cdfr/octree/options.h"
#include "core/progress.h"
#include "octree/blocks.h"
#include "octree/refine.h"
#include "octree/search.h"

namespace cdfr {

/// Says of a cell that no leaf in it is to have a list of its own. `away`: no triangle is closer to the
/// cell's centre. `is_free`: none comes into the cell. Thread safe. An empty one leaves nothing out.
using LeftOut = std::function<bool(const Cell& cell, double away, bool is_free)>;

/// A cell splits while its list is longer than the threshold, it is above the deepest level, and the split
/// pays: the mean list of the children is at most `gain` of its own. Where two walls are equally far a split
/// halves half of the lists for ever, so there is a limit to the block's leaves too; what is left of it goes
/// to the longest lists. Working memory is one level's lists.
class BlockBuilder {
 public:
  BlockBuilder(SearchSpace space, const Lattice& lattice, const BuildOptions& options,
               const RefineOptions& refining, RefineScratch& scratch, std::uint64_t most_leaves,
               const LeftOut& left_out, Progress& progress)
      : space_(space),
        lattice_(lattice),
        options_(options),
        refining_(refining),
        scratch_(scratch),
        most_leaves_(most_leaves),
        left_out_(left_out),
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
  double away(const OpenCell& cell) const noexcept;
  bool is_left_out(const OpenCell& cell, bool is_free) const;
  void close(Growing&& cell);
  void leave_out(const Growing& cell);
  std::vector<Entry> listed(const std::vector<Candidate>& candidates) const;
  Box grown_box(const Cell& cell) const noexcept;
  bool is_far(const OpenCell& cell) const noexcept;
  bool may_cross(const OpenCell& cell) const;
  void add_leaf(const Growing& cell, bool crossed, std::vector<Entry> list);
  Block laid_out(std::uint64_t key);

  SearchSpace space_;
  const Lattice& lattice_;
  const BuildOptions& options_;
  const RefineOptions& refining_;
  RefineScratch& scratch_;
  std::uint64_t most_leaves_;
  const LeftOut& left_out_;
  Progress& progress_;
  std::vector<TreeNode> nodes_;
  std::vector<std::vector<Entry>> lists_;  ///< of closed cells, in the order they closed
  std::vector<bool> crossed_;
  std::vector<LevelStats> levels_;
};

}  // namespace cdfr
