/// Cubes of space, and which of them a contour may enter.
#pragma once

#include <cmath>

#include "cdfr/core/types.h"
#include "contour/level.h"

namespace cdfr {

struct Cube {
  Vec3 lo;
  double size = 0;

  Vec3 centre() const noexcept { return {lo.x + size / 2, lo.y + size / 2, lo.z + size / 2}; }
  Cube octant(int child) const noexcept {
    const double half = size / 2;
    return {{lo.x + (child & 1 ? half : 0), lo.y + (child & 2 ? half : 0), lo.z + (child & 4 ? half : 0)},
            half};
  }
  double half_diagonal() const noexcept { return 0.8660254037844387 * size; }
};

/// May the cube hold a point of the contour, given the value at its centre?
inline bool passes(const Level& level, double value, const Cube& cube) noexcept {
  return std::fabs(value - level.height) <= level.reach(cube.half_diagonal()) + level.rounding;
}

}  // namespace cdfr
