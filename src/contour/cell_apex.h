/// The point of a cell that its fan is spun from.
#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <span>

#include "contour/crossings.h"
#include "contour/sought.h"

namespace cdfr {

/// A cube in plain vectors.
struct PlainCube {
  Eigen::Vector3d lo;
  double size = 0;

  /// The nearest point off its border by a hair.
  Eigen::Vector3d held(const Eigen::Vector3d& x) const noexcept {
    const double hair = size * hair_share;
    return x.cwiseMax((lo.array() + hair).matrix()).cwiseMin((lo.array() + (size - hair)).matrix());
  }
  bool has(const Eigen::Vector3d& x) const noexcept { return held(x) == x; }
};

/// What is measured on the way.
struct SurfaceTally {
  double largest_error = 0;
  std::uint64_t evaluations = 0;
};

/// By the length of the loop next to it.
struct WeightedCrossing {
  const Crossing* crossing = nullptr;
  double weight = 0;
};

/// Strictly inside the cube: where the tangent planes at the loop's crossings meet (qef.h) if the contour is
/// there, so that its edges and corners are kept; on a round or flat piece the loop's mean, moved along the
/// mean normal onto the mean tangent. Of several such points the one whose distance is right, or nearest to
/// it. `mean` is that of the loop's points.
Eigen::Vector3d cell_apex(const Sought& sought, const PlainCube& cube, const Eigen::Vector3d& mean,
                          std::span<const WeightedCrossing> crossings, SurfaceTally& tally);

}  // namespace cdfr
