/// The contour asked for, and a sample of the distance seen from its side.
#pragma once

#include <cmath>
#include <cstdint>

#include "cdfr/core/types.h"
#include "field/field_data.h"
#include "field/query.h"

namespace cdfr {

/// The signed distance t as a side and a height: the contour is where value() equals `height`. Inside (t < 0)
/// the signed distance is turned round, so that values grow away from the surface on the contour's own side.
struct Level {
  double height = 0;  ///< |t|
  double side = 1;    ///< -1 inside
  double rounding =
      0;  ///< 16 ulp at the largest coordinate in play: covers the kernel (4) and one point's arithmetic

  double value(double signed_distance) const noexcept { return side * signed_distance; }
};

/// A point with all that is needed to move from it.
struct Sample {
  Vec3 position;
  double value = 0;
  Vec3 foot;      ///< closest surface point
  Vec3 gradient;  ///< of the signed distance
  std::uint32_t triangle = no_index;
};

inline double value_at(const FieldData& field, const Level& level, const Vec3& x) noexcept {
  return level.value(signed_distance(field, x));
}

inline Sample sample_at(const FieldData& field, const Level& level, const Vec3& x) noexcept {
  const Closest closest = closest_point(field, x, Finder::tree);
  return {x, level.value(closest.distance), closest.point, closest.gradient, closest.triangle};
}

}  // namespace cdfr
