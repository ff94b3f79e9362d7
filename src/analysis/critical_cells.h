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
/// - foot of the triangles that can be closest in the cell (field/near_triangles.h): the map x -> x - foot(x,
/// T) changes by at most |x - c| since T is convex, so from any point of the cell all of them go along u.
/// Cells are halved until that proves it, or until one point of the cell, its core, tells enough of it:
///  - its half diagonal is half the error: the centre; or
///  - no point of it is deeper than the core by more than half the error (field/distance_above.h, exact
///    between parallel walls), and its edge s is short enough for s^2 <= error * depth. Between the middles
///    of two cells of a plate the depth then falls by less than half the error (way_depth). So the middle of
///    a plate takes cells of about its thickness.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/progress.h"
#include "field/field_data.h"
#include "octree/key.h"

namespace cdfr {

struct CriticalCell {
  std::uint64_t key = 0;  ///< octree/key.h
  Vec3 core;
  double depth = 0;      ///< of the core
  bool touched = false;  ///< a marked triangle can be closest in the cell
};

struct CriticalCells {
  int level = 0;                    ///< of the smallest
  double size = 0;                  ///< edge of those
  std::vector<CriticalCell> cells;  ///< disjoint, in Morton order

  static constexpr std::size_t none = ~std::size_t{0};
  /// Number of the cell that holds all of that one, or begins where it does; or none. O(log n).
  std::size_t find(const Cell& cell) const noexcept;
};

/// How well the depth's critical points are looked for.
struct CriticalSearch {
  double error = 0;
  double floor = 0;                        ///< only what is deeper; at least the error
  std::span<const std::uint8_t> marked{};  ///< a byte for each slot, or empty
};

/// The level whose cells have half a diagonal of at most error / 2; above deepest_level if there is none.
int level_of_error(const Lattice& lattice, double error) noexcept;

/// Cells that hold all critical points. Preconditions: the field is signed and its sign changes on the
/// surface alone; the error's level is there. Runs in the caller's task arena; empty if cancelled.
CriticalCells critical_cells(const FieldData& field, const CriticalSearch& search, Progress& progress);

/// No point of the straight way from one place inside to another is less deep, given the depths at its ends:
/// the squared distance less |x|^2 is concave (octree/influence.h), so at the share t of the way
///     d^2 >= (1 - t) d_a^2 + t d_b^2 - t (1 - t) |b - a|^2.
/// 0 if that does not keep the way inside.
double way_depth(const Vec3& a, double depth_a, const Vec3& b, double depth_b) noexcept;

}  // namespace cdfr
