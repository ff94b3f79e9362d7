/// A direction that many vectors have in common.
#pragma once

#include <Eigen/Core>
#include <span>

namespace cdfr {

struct CommonDirection {
  Eigen::Vector3d direction = Eigen::Vector3d::Zero();  ///< unit, or zero if none was found
  double least = 0;  ///< every vector goes at least so far along it; at most 0 if none was found
};

/// Looks for the unit direction u with the largest min of w.u over the vectors w. That is the direction of
/// the point closest to the origin in their convex hull, and its distance from there is the minimum (von
/// Neumann's duality). Gilbert's iteration (1966) goes to that point: from x to the point closest to the
/// origin on the segment from x to the vector that is least along x. It ends as soon as the least exceeds
/// `enough`, or |x|, which bounds it from above, does not. What it finds is always true of the vectors; that
/// it finds nothing proves nothing.
CommonDirection common_direction(std::span<const Eigen::Vector3d> vectors, double enough) noexcept;

}  // namespace cdfr
