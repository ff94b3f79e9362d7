/// How far apart the points of a cloud are.
#pragma once

#include <span>

#include "cdfr/core/sinks.h"
#include "cdfr/core/types.h"

namespace cdfr {

/// Mean distance of neighbours if the points lie on surfaces; 0 if there are too few to tell. `box` holds all
/// points. Independent of their order. O(n log n).
double spacing_on_surface(std::span<const ContourPoint> points, const Box& box);

}  // namespace cdfr
