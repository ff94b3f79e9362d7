#include <vector>

#include "reference/uniform_data.h"

namespace cdfr {
namespace {

bool in_outermost_layer(const VoxelGrid& grid, std::size_t cell) noexcept {
  const VoxelGrid::Place p = grid.place(cell);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (p[axis] == 0 || p[axis] == grid.counts[axis] - 1) return true;
  }
  return false;
}

}  // namespace

/// Two untouched voxels that share as much as a corner are on the same side, for no triangle touches that
/// corner: the flood may go to all 26 neighbours. The paper does not say to which it goes. With
/// UniformVoxels::points the same holds: of two neighbours' points, at most sqrt(3) voxels apart, on two
/// sides of the surface, one is within a voxel of it.
void flood_outside(UniformData& data) {
  std::vector<std::size_t> reached;
  const auto reach = [&](std::size_t cell) {
    if (data.sides[cell] != Side::inside) return;
    data.sides[cell] = Side::outside;
    reached.push_back(cell);
  };
  for (std::size_t cell = 0; cell < data.sides.size(); ++cell) {
    if (in_outermost_layer(data.grid, cell)) reach(cell);
  }
  while (!reached.empty()) {
    const std::size_t cell = reached.back();
    reached.pop_back();
    data.grid.for_each_neighbour(cell, reach);
  }
}

}  // namespace cdfr
