/// Volume, surface and extent of a section, from its cells.
///
/// A cell holds at least its sure part of {depth > T} and at most its possible part (heavy_cell.h); the
/// volumes of both are exact, so their sums bound the section's. The surface is that of the plane half-way
/// between the two in each cell.
#pragma once

#include <cstdint>
#include <vector>

#include "analysis/heavy_cell.h"
#include "cdfr/analysis/sections.h"
#include "field/field_data.h"

namespace cdfr {

class SectionMeasure {
 public:
  void add(const CoreRule& rule, const HeavyCell& cell);
  /// A cell that may belong to the section or to another one.
  void add_doubtful(const HeavyCell& cell);
  /// The triangle of that number in the input bounds it.
  void add_triangle(std::uint32_t number);

  /// All but the ball.
  Section section(const Lattice& lattice);

  /// Depth above T, in edges of the lattice, of the deepest core point.
  double deepest() const noexcept { return deepest_; }

 private:
  void extend(const HeavyCell& cell, double half);

  // In edges of the lattice.
  double sure_ = 0, possible_ = 0, cut_ = 0;
  double area_ = 0, area_low_ = 0, area_high_ = 0, tilt_ = 0;
  double deepest_ = 0;
  Box box_{{HUGE_VAL, HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}};
  std::uint64_t cells_ = 0;
  std::vector<std::uint32_t> triangles_;
  std::size_t sorted_ = 0;  ///< of the triangles, when they were made unique last
};

}  // namespace cdfr
