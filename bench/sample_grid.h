/// The corners of a dense grid, in the order in which solvers fill theirs: x fastest, then y, then z.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "cdfr/core/types.h"

namespace cdfr::bench {

struct SampleGrid {
  Vec3 origin, spacing;
  std::array<std::uint32_t, 3> size{};

  std::size_t count() const noexcept { return std::size_t{size[0]} * size[1] * size[2]; }
  Vec3 point(std::uint32_t i, std::uint32_t j, std::uint32_t k) const noexcept {
    return {origin.x + spacing.x * i, origin.y + spacing.y * j, origin.z + spacing.z * k};
  }
};

/// The part of a grid from plane `first` on, as a grid of its own.
inline SampleGrid slab(const SampleGrid& grid, std::uint32_t first, std::uint32_t planes) {
  return {grid.point(0, 0, first), grid.spacing, {grid.size[0], grid.size[1], planes}};
}

/// The points of `planes` planes from `first` on.
inline std::vector<Vec3> points_of(const SampleGrid& grid, std::uint32_t first, std::uint32_t planes) {
  std::vector<Vec3> points;
  points.reserve(std::size_t{grid.size[0]} * grid.size[1] * planes);
  for (std::uint32_t k = first; k < first + planes; ++k) {
    for (std::uint32_t j = 0; j < grid.size[1]; ++j) {
      for (std::uint32_t i = 0; i < grid.size[0]; ++i) points.push_back(grid.point(i, j, k));
    }
  }
  return points;
}

}  // namespace cdfr::bench
