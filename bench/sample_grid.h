/// The corners of a dense grid, in the order in which solvers fill theirs: x fastest, then y, then z.
#pragma once

#include <cstddef>
#include <vector>

#include "cdfr/core/types.h"

namespace cdfr::bench {

struct SampleGrid {
  Vec3 origin, spacing;
  std::size_t side = 256;  ///< points along each axis

  std::size_t plane_points() const noexcept { return side * side; }
  Vec3 point(std::size_t i, std::size_t j, std::size_t k) const noexcept {
    return {origin.x + spacing.x * static_cast<double>(i), origin.y + spacing.y * static_cast<double>(j),
            origin.z + spacing.z * static_cast<double>(k)};
  }
  std::vector<Vec3> planes(std::size_t first, std::size_t count) const {
    std::vector<Vec3> points;
    points.reserve(count * plane_points());
    for (std::size_t k = first; k < first + count; ++k) {
      for (std::size_t j = 0; j < side; ++j) {
        for (std::size_t i = 0; i < side; ++i) points.push_back(point(i, j, k));
      }
    }
    return points;
  }
};

}  // namespace cdfr::bench
