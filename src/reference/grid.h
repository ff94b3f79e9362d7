/// Where the voxels of a uniform field lie, and which of them are neighbours.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "cdfr/core/types.h"

namespace cdfr {

struct VoxelGrid {
  using Place = std::array<int, 3>;

  Vec3 origin;
  double size = 1;              ///< edge of a voxel
  std::array<int, 3> counts{};  ///< voxels along each axis
  /// 16 ulp at the grid's largest coordinate: more than rounding moves a corner, a centre or a distance.
  double slack = 0;

  std::size_t cell_count() const noexcept {
    return static_cast<std::size_t>(counts[0]) * static_cast<std::size_t>(counts[1]) *
           static_cast<std::size_t>(counts[2]);
  }
  std::size_t number(const Place& p) const noexcept {
    return (static_cast<std::size_t>(p[2]) * static_cast<std::size_t>(counts[1]) +
            static_cast<std::size_t>(p[1])) *
               static_cast<std::size_t>(counts[0]) +
           static_cast<std::size_t>(p[0]);
  }
  Place place(std::size_t cell) const noexcept {
    const auto x = static_cast<std::size_t>(counts[0]), y = static_cast<std::size_t>(counts[1]);
    return {static_cast<int>(cell % x), static_cast<int>(cell / x % y), static_cast<int>(cell / x / y)};
  }
  /// Point of the lattice, counted in voxels from the origin. Neighbours share corners to the bit.
  Vec3 at(double x, double y, double z) const noexcept {
    return {origin.x + x * size, origin.y + y * size, origin.z + z * size};
  }
  Box box(const Place& p) const noexcept { return {at(p[0], p[1], p[2]), at(p[0] + 1, p[1] + 1, p[2] + 1)}; }
  Vec3 centre(const Place& p) const noexcept { return at(p[0] + 0.5, p[1] + 0.5, p[2] + 0.5); }

  /// The voxel whose half-open box holds x; nothing beyond the grid or if x is not finite.
  std::optional<Place> locate(const Vec3& x) const noexcept {
    const std::array<double, 3> value{x.x, x.y, x.z}, start{origin.x, origin.y, origin.z};
    Place p{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double along = (value[axis] - start[axis]) / size;
      if (!(along > -1 && along < counts[axis] + 1.0)) return std::nullopt;
      int i = static_cast<int>(along);
      while (value[axis] < start[axis] + i * size) --i;
      while (value[axis] >= start[axis] + (i + 1) * size) ++i;
      if (i < 0 || i >= counts[axis]) return std::nullopt;
      p[axis] = i;
    }
    return p;
  }

  /// visit(number) for the voxel's up to 26 neighbours, ascending.
  template <class Visit>
  void for_each_neighbour(std::size_t cell, Visit visit) const {
    const Place p = place(cell);
    for (int z = std::max(p[2] - 1, 0); z <= std::min(p[2] + 1, counts[2] - 1); ++z) {
      for (int y = std::max(p[1] - 1, 0); y <= std::min(p[1] + 1, counts[1] - 1); ++y) {
        for (int x = std::max(p[0] - 1, 0); x <= std::min(p[0] + 1, counts[0] - 1); ++x) {
          if (const std::size_t other = number({x, y, z}); other != cell) visit(other);
        }
      }
    }
  }
};

/// Half the diagonal of a cube of edge 1.
inline constexpr double half_diagonal_of_unit = 0.8660254037844387;

}  // namespace cdfr
