/// Distances at corners of the grid, each computed once.
#pragma once

#include <cstdint>
#include <vector>

#include "contour/numbering.h"
#include "contour/sought.h"
#include "contour/surface_lattice.h"
#include "core/progress.h"

namespace cdfr {

class CornerValues {
 public:
  CornerValues(const Sought& sought, const SurfaceLattice& lattice) : sought_(sought), lattice_(lattice) {}

  /// A number that stays the corner's: in the order of first calls.
  std::uint32_t number(const GridPlace& place);
  /// Computes what is missing. False if cancelled.
  bool evaluate(Progress& progress);

  double operator[](std::uint32_t number) const noexcept { return values_[number]; }
  bool held(std::uint32_t number) const noexcept { return sought_.holds(values_[number]); }
  Vec3 position(std::uint32_t number) const noexcept { return positions_[number]; }
  std::uint64_t evaluations() const noexcept { return values_.size(); }

 private:
  const Sought& sought_;
  const SurfaceLattice& lattice_;
  Numbering numbering_;
  std::vector<Vec3> positions_;  ///< by number
  std::vector<double> values_;   ///< by number; as many as are computed
};

}  // namespace cdfr
