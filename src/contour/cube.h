/// Which cubes a contour may enter, and how far they are halved.
#pragma once

#include <cmath>

#include "contour/level.h"
#include "geometry/cube.h"

namespace cdfr {

/// May the cube hold a point of the contour, given the value at its centre?
inline bool passes(const Level& level, double value, const Cube& cube) noexcept {
  return std::fabs(value - level.height) <= level.reach(cube.half_diagonal()) + level.rounding;
}

/// Edge of the final cubes that a cube of that edge is halved into.
inline double final_size(const Level& level, double size) noexcept {
  while (!level.is_final(Cube{{}, size}.half_diagonal())) size /= 2;
  return size;
}

}  // namespace cdfr
