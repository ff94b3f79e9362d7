/// Cubes of space along the axes.
#pragma once

#include "cdfr/core/types.h"

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

}  // namespace cdfr
