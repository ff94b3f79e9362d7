/// Colours: warm opaque points inside a pale, translucent part, on white.
#pragma once

#include <Eigen/Core>

#include "render/band.h"

namespace cdfr {

/// Rows and columns around a sample that its colour depends on.
inline constexpr int shade_reach = 3;

/// Colour of one sample, each channel 0 to 1. Rows within shade_reach that the band does not hold count as
/// empty. `depth` is the greatest depth of the fitted box, in samples.
Eigen::Vector3f shade(const Band& band, int column, int row, float depth);

}  // namespace cdfr
