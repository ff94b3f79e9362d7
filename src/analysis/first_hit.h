/// What rays meet first behind a wall: thickness by the ray method.
#pragma once

#include "analysis/measured_wall.h"
#include "field/field_data.h"

namespace cdfr {

struct RayOptions {
  int rays = 1;
  double cone = 0;      ///< half its opening, degrees
  double largest = 0;   ///< no ray is longer
  double rounding = 0;  ///< what lies within it of a point touches it
};

/// The shortest of the rays from the point along its direction and on a spiral about it, whose points on the
/// cone's cap each stand for the same area (golden angle; Vogel, "A better way to construct the sunflower
/// head", 1979). A ray meets every triangle that it does not certainly miss, but for the point's own and
/// those that touch the point.
MeasuredWall shortest_ray(const FieldData& field, const WallPoint& point, const RayOptions& options) noexcept;

}  // namespace cdfr
