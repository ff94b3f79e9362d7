/// Names of cells: level and place as one 64-bit number that sorts in Morton order.
///
/// The octree is a brick of at most 8 x 8 x 8 cubes inside a virtual cube of level -3; levels 0 (the brick's
/// cubes) to 18 are real. A key is a sentinel 1 followed by three bits a level (z, y, x) from the virtual
/// cube down: 63 bits at most.
#pragma once

#include <array>
#include <bit>
#include <cstdint>

namespace cdfr {

inline constexpr int virtual_levels = 3;
inline constexpr int deepest_level = 18;

/// A cell by its level and its integer place on that level's lattice, 0 .. 2^(level + 3) - 1 on each axis.
struct Cell {
  int level = -virtual_levels;
  std::array<std::uint32_t, 3> place{};

  friend bool operator==(const Cell&, const Cell&) = default;
};

/// Child 0 to 7: bit 0 is x, bit 1 y, bit 2 z.
inline Cell child_of(const Cell& cell, int child) noexcept {
  return {cell.level + 1,
          {2 * cell.place[0] + (child & 1U), 2 * cell.place[1] + ((child >> 1) & 1U),
           2 * cell.place[2] + ((child >> 2) & 1U)}};
}

inline std::uint64_t key_of(const Cell& cell) noexcept {
  std::uint64_t key = 1;
  for (int bit = cell.level + virtual_levels - 1; bit >= 0; --bit) {
    key = key << 3 | ((cell.place[2] >> bit) & 1U) << 2 | ((cell.place[1] >> bit) & 1U) << 1 |
          ((cell.place[0] >> bit) & 1U);
  }
  return key;
}

/// Precondition: key is key_of some cell.
inline Cell cell_of(std::uint64_t key) noexcept {
  const int levels = (63 - std::countl_zero(key)) / 3;
  Cell cell{levels - virtual_levels, {}};
  for (int bit = levels - 1; bit >= 0; --bit) {
    const std::uint64_t child = key >> (3 * bit) & 7U;
    for (int axis = 0; axis < 3; ++axis) {
      cell.place[axis] = cell.place[axis] << 1 | static_cast<std::uint32_t>(child >> axis & 1U);
    }
  }
  return cell;
}

}  // namespace cdfr
