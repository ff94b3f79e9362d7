#include "analysis/task_cells.h"

namespace cdfr {

std::vector<Cell> task_cells(const Lattice& lattice, int level) {
  std::vector<Cell> cells;
  const auto along = [&](int axis) { return lattice.bricks[static_cast<std::size_t>(axis)] << level; };
  for (std::uint32_t z = 0; z < along(2); ++z)
    for (std::uint32_t y = 0; y < along(1); ++y)
      for (std::uint32_t x = 0; x < along(0); ++x) cells.push_back({level, {x, y, z}});
  return cells;
}

}  // namespace cdfr
