/// The point where planes meet best: the quadratic error function of Garland and Heckbert (1997), as dual
/// contouring uses it.
#pragma once

#include <Eigen/Core>

namespace cdfr {

/// Sums over planes normal.(x - origin) = offset, about a point `origin` near the answer, with weights.
class PlaneMeeting {
 public:
  void add(const Eigen::Vector3d& normal, double offset, double weight) noexcept {
    square_ += weight * normal * normal.transpose();
    right_ += weight * offset * normal;
    weight_ += weight;
  }
  /// The least squares point nearest to the origin (Lindstrom 2000): directions in which the normals spread
  /// less than `least_share` of the weight do not move it. Also how many directions count.
  Eigen::Vector3d point(double least_share, int& rank) const;
  /// The best point of the box lo .. hi: each coordinate is free or at either end, and of these 27 cases the
  /// least error that stays inside wins. Directions without a say are held at the origin by a weight of
  /// 2^-20.
  Eigen::Vector3d point_in(const Eigen::Vector3d& lo, const Eigen::Vector3d& hi) const;

 private:
  Eigen::Matrix3d square_ = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right_ = Eigen::Vector3d::Zero();
  double weight_ = 0;
};

}  // namespace cdfr
