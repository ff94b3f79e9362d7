/// Distance from a point to one triangle in plain double arithmetic: for decisions on how coarse a cell may
/// be, never for signs.
#pragma once

#include <Eigen/Core>

#include "geometry/point_triangle.h"

namespace cdfr {

/// The distance and its gradient, a unit vector from the closest point; zero at distance 0.
struct PlainFoot {
  double distance = 0;
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
};

/// Off by less than 2^-38 of the largest distance to a vertex: as in the kernel (point_triangle.h) the face
/// counts only where the projection is inside all edges by more than rounding, else the three edges answer,
/// which are at most that much farther.
PlainFoot plain_foot(const Eigen::Vector3d& p, const TriangleShape& triangle) noexcept;

}  // namespace cdfr
