/// The point where planes meet best: the quadratic error function of Garland and Heckbert (1997), as dual
/// contouring uses it.
#pragma once

#include <Eigen/Core>

namespace cdfr {

/// Sums over planes normal.(x - origin) = offset, about a point `origin` near the answer.
class PlaneMeeting {
 public:
  void add(const Eigen::Vector3d& normal, double offset) noexcept {
    square_ += normal * normal.transpose();
    right_ += normal * offset;
    ++count_;
  }
  /// The least squares point nearest to the origin (Lindstrom 2000): directions in which the normals spread
  /// less than `least_share` of the number of planes do not move it. Also how many directions count.
  Eigen::Vector3d point(double least_share, int& rank) const;

 private:
  Eigen::Matrix3d square_ = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right_ = Eigen::Vector3d::Zero();
  int count_ = 0;
};

}  // namespace cdfr
