/// Where the depth can have a critical point: the cells in which the part's balls cannot grow by moving.
///
/// The depth is the least of the distances to the triangles. A point x is critical if no direction takes it
/// away from all triangles that are closest to it, that is if the origin lies in the convex hull of the
/// vectors x - foot. Maxima of the depth, necks between them and middles of plates are critical; where no
/// point is, the depth has no maximum and its level sets do not change their shape (Grove 1993, "Critical
/// point theory for distance functions"; Lieutier 2004, "Any open bounded subset of R^n has the same homotopy
/// type as its medial axis").
///
/// A cell of centre c and half diagonal h has no critical point if some direction u has w.u > h for all w = c
/// - foot of the triangles that can be closest in the cell (near_triangles.h): the map x -> x - foot(x, T)
/// changes by at most |x - c| since T is convex, so from any point of the cell all of them go along u. Cells
/// are halved until that proves it, or until their half diagonal is half the error.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/progress.h"
#include "field/field_data.h"
#include "octree/key.h"

namespace cdfr {

struct CriticalCell {
  std::uint64_t key = 0;  ///< octree/key.h, all of one level
  double depth = 0;       ///< of the centre
  bool touched = false;   ///< a marked triangle can be closest in the cell
};

struct CriticalCells {
  int level = 0;
  double size = 0;                  ///< edge of a cell
  std::vector<CriticalCell> cells;  ///< ascending keys

  static constexpr std::size_t none = ~std::size_t{0};
  /// The cell's number, or none. O(log n).
  std::size_t find(std::uint64_t key) const noexcept;
};

/// The level whose cells have half a diagonal of at most error / 2; above deepest_level if there is none.
int level_of_error(const Lattice& lattice, double error) noexcept;

/// All cells of that level that may hold a critical point deeper than `floor`. `marked` has a byte for each
/// slot, or is empty. Preconditions: the field is signed and its sign changes on the surface alone; floor is
/// at least a cell's diagonal. Runs in the caller's task arena; empty if cancelled.
CriticalCells critical_cells(const FieldData& field, int level, double floor,
                             std::span<const std::uint8_t> marked, Progress& progress);

/// visit(number) for each critical cell that has a point in common with it.
template <class Visit>
void for_each_touching(const CriticalCells& critical, const Cell& cell, Visit visit) {
  const std::uint32_t end = std::uint32_t{1} << (cell.level + virtual_levels);
  for (int step = 0; step < 27; ++step) {
    const std::array<std::uint32_t, 3> place{cell.place[0] + static_cast<std::uint32_t>(step % 3 - 1),
                                             cell.place[1] + static_cast<std::uint32_t>(step / 3 % 3 - 1),
                                             cell.place[2] + static_cast<std::uint32_t>(step / 9 - 1)};
    if (step == 13 || place[0] >= end || place[1] >= end || place[2] >= end) continue;
    const std::size_t number = critical.find(key_of({cell.level, place}));
    if (number != CriticalCells::none) visit(number);
  }
}

}  // namespace cdfr
