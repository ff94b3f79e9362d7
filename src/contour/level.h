/// The contour asked for, and a sample of the distance seen from its side.
#pragma once

#include <cmath>
#include <cstdint>

#include "cdfr/contour/contour.h"
#include "cdfr/core/types.h"
#include "field/field_data.h"
#include "field/query.h"

namespace cdfr {

/// The signed distance t as a side and a height: the contour is where value() equals `height`. Inside (t < 0)
/// the signed distance is turned round, so that values grow away from the surface on the contour's own side.
///
/// Where the mesh is open the sign changes off the surface too and the signed distance jumps there. Then
/// values are unsigned, which have slope 1 everywhere, and points on the wrong side are left out.
struct Level {
  double height = 0;    ///< |t|
  double side = 1;      ///< -1 inside
  double rounding = 0;  ///< point_rounding
  bool jumps = false;
  Rule rule = Rule::closed;
  double tolerance = 0;

  /// Is a cube of that half diagonal halved no more?
  bool is_final(double half_diagonal) const noexcept {
    return rule == Rule::closed ? half_diagonal <= tolerance / 2 : half_diagonal < tolerance;
  }
  /// How far the value at a cube's centre may be from the height if a final cube in it gives a point: the
  /// distance has slope 1, and the centres of the cubes in it are within the difference of the half
  /// diagonals.
  double reach(double half_diagonal) const noexcept {
    if (rule == Rule::closed) return half_diagonal;
    double last = half_diagonal;
    while (!is_final(last)) last /= 2;
    return half_diagonal - last + tolerance / 2;
  }

  double value(double signed_distance) const noexcept {
    return jumps ? std::fabs(signed_distance) : side * signed_distance;
  }
  bool on_side(double signed_distance) const noexcept { return (signed_distance < 0) == (side < 0); }
  Side other_side() const noexcept { return side < 0 ? Side::outside : Side::inside; }
};

/// A point with all that is needed to move from it.
struct Sample {
  Vec3 position;
  double value = 0;
  bool on_side = true;
  Vec3 foot;      ///< closest surface point
  Vec3 gradient;  ///< of the signed distance
  std::uint32_t triangle = no_index;
};

inline double value_at(const FieldData& field, const Level& level, const Vec3& x) noexcept {
  return level.value(signed_distance(field, x));
}

inline Sample sample_at(const FieldData& field, const Level& level, const Vec3& x) noexcept {
  const Closest closest = closest_point(field, x, Finder::tree);
  return {x,
          level.value(closest.distance),
          level.on_side(closest.distance),
          closest.point,
          closest.gradient,
          closest.triangle};
}

}  // namespace cdfr
