/// What one measurement of a wall, or of a gap, has found.
#pragma once

#include <cstdint>

#include "cdfr/core/types.h"

namespace cdfr {

struct MeasuredWall {
  double thickness = 0;  ///< NaN where nothing was met
  double error = 0;
  Vec3 opposite_point;
  std::uint32_t opposite = no_index;  ///< triangle: its number in the input
  std::uint32_t opposite_patch = 0;
};

/// A point that holds a wall between itself and what lies along `direction`, a unit vector.
struct WallPoint {
  Vec3 position;
  Vec3 direction;
  std::uint32_t slot = no_index;  ///< of the triangle that it lies on
  double facet = 0;               ///< D, for the ball
};

}  // namespace cdfr
