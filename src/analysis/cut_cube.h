/// What a plane cuts from a cube.
#pragma once

#include "cdfr/core/types.h"

namespace cdfr {

struct CubeCut {
  double volume = 0;  ///< of the part of the cube where offset + way.y > 0
  double area = 0;    ///< of the plane in the cube
};

/// Of the cube [-half, half]^3. Volumes are good to 2^-28 of the cube's if each component of `way` is 0 or at
/// least 2^-20 of the largest (Scardovelli and Zaleski, "Analytical relations connecting linear interfaces
/// and volume fractions in rectangular grids", 2000): the formula divides differences of cubes by the product
/// of all three.
CubeCut cut_cube(const Vec3& way, double offset, double half) noexcept;

}  // namespace cdfr
