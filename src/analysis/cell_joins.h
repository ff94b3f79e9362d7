/// Which cells belong together: for certain, or perhaps.
///
/// A core is a set of cells whose core points hang together by straight ways, all deeper than T, so it lies
/// in one component of {depth > T}. Two cells whose possible parts reach a common face without such a way are
/// a doubt. All of a component of {depth > T} lies in cells that are linked by cores and doubts, as its
/// points on a face between two cells lie in the possible parts of both.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "analysis/cell_index.h"
#include "analysis/heavy_cell.h"
#include "core/progress.h"
#include "mesh/disjoint_sets.h"

namespace cdfr {

/// Two cells, by number.
struct Doubt {
  std::uint32_t a, b;
};

struct CellJoins {
  DisjointSets cores;          ///< over the cells
  std::vector<bool> has_core;  ///< by cell
  std::vector<Doubt> doubts;   ///< between different sets

  std::uint32_t root(std::uint32_t i) noexcept { return static_cast<std::uint32_t>(cores.root(i)); }
  /// The root of the cell's core, or no_index if it has none. The root of a set is its lowest number; halved
  /// cells (necks.h) come after those that were found first, and have no core of their own.
  std::uint32_t core_of(std::uint32_t i) noexcept {
    const std::uint32_t own = root(i);
    return own < has_core.size() && has_core[own] ? own : no_index;
  }
};

CellJoins join_cells(const CoreRule& rule, std::span<const HeavyCell> cells, const CellIndex& index,
                     Progress& progress);

/// Cells without a core that are linked by doubts, and the cores that they touch.
struct DoubtCluster {
  std::vector<std::uint32_t> cells;  ///< roots of their sets, ascending
  std::vector<std::uint32_t> cores;  ///< roots, ascending
};

/// Clusters ascend by their first cells.
std::vector<DoubtCluster> doubt_clusters(std::span<const Doubt> doubts, CellJoins& joins);

/// Where the territories of two cores meet: each cell in doubt is in that of the core to which fewest steps
/// lead.
struct Seam {
  std::uint32_t first, second;  ///< roots, first < second
  Doubt doubt;
};
std::vector<Seam> seams_between(std::span<const Doubt> doubts, CellJoins& joins);

}  // namespace cdfr
