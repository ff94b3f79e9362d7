#include "contour/qef.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <array>
#include <limits>

namespace cdfr {

Eigen::Vector3d PlaneMeeting::point(double least_share, int& rank) const {
  // Householder reduction and QR steps, without the closed form's arc functions, whose bits a C library
  // decides.
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(square_);
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  rank = 0;
  for (Eigen::Index i = 0; i < 3; ++i) {
    const double value = solver.eigenvalues()[i];
    if (!(value > least_share * weight_)) continue;
    ++rank;
    const Eigen::Vector3d axis = solver.eigenvectors().col(i);
    point += axis * (axis.dot(right_) / value);
  }
  return point;
}

Eigen::Vector3d PlaneMeeting::point_in(const Eigen::Vector3d& lo, const Eigen::Vector3d& hi) const {
  const Eigen::Matrix3d square = square_ + 0x1p-20 * weight_ * Eigen::Matrix3d::Identity();
  Eigen::Vector3d best = Eigen::Vector3d::Zero().cwiseMax(lo).cwiseMin(hi);
  double least = std::numeric_limits<double>::infinity();
  for (int choice = 0; choice < 27; ++choice) {
    const std::array<int, 3> at{choice % 3, choice / 3 % 3, choice / 9};
    // Rows of fixed coordinates say x = end.
    Eigen::Matrix3d rows = square;
    Eigen::Vector3d right = right_;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      if (at[axis] == 0) continue;
      rows.row(axis).setZero();
      rows(axis, axis) = 1;
      right[axis] = at[axis] == 1 ? lo[axis] : hi[axis];
    }
    const Eigen::Vector3d x = rows.inverse() * right;
    const Eigen::Vector3d inside = x.cwiseMax(lo).cwiseMin(hi);
    // A free coordinate beyond an end by rounding is one at that end.
    if (!((x - inside).lpNorm<Eigen::Infinity>() <= 0x1p-30 * (hi - lo).lpNorm<Eigen::Infinity>())) continue;
    const double error = inside.dot(square * inside) - 2 * inside.dot(right_);
    if (error < least) {
      least = error;
      best = inside;
    }
  }
  return best;
}

}  // namespace cdfr
