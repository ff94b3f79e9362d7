/// A ball inside a part.
#pragma once

#include <cstdint>
#include <vector>

#include "cdfr/core/types.h"

namespace cdfr {

/// The largest ball that fits in some region of the part, to a stated error. Its diameter, 2 radius, is what
/// an engineer calls the thickness there.
struct InscribedBall {
  Vec3 centre;
  double radius = 0;  ///< depth of the centre: the ball is inside the part and touches its surface
  double error = 0;   ///< no ball around a point of the region has a radius above radius + error
  /// Numbers in the input of the triangles no farther from the centre than radius + 2 error, ascending: what
  /// holds the largest ball, and what is as close but for the error.
  std::vector<std::uint32_t> touches;
};

}  // namespace cdfr
