/// The surface that is looked for, and what every step of the search needs to know of it.
#pragma once

#include <cmath>

#include "cdfr/core/types.h"
#include "contour/flatness.h"
#include "field/field_data.h"

namespace cdfr {

struct Sought {
  const FieldData& field;
  double distance = 0;   ///< signed
  double tolerance = 0;  ///< E
  Slack slack;           ///< between the distance in a coarse cell and what it is taken for
  double rounding = 0;   ///< point_rounding

  double height() const noexcept { return std::fabs(distance); }
  /// Of the set that the mesh bounds.
  bool holds(double signed_distance) const noexcept { return signed_distance < distance; }
  /// On the contour's side of the surface, at its height or farther off: what unsigned bounds tell of.
  bool is_high(double signed_distance) const noexcept {
    return distance < 0 ? signed_distance <= distance : signed_distance >= distance;
  }
};

}  // namespace cdfr
