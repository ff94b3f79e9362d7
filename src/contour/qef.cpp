#include "contour/qef.h"

#include <Eigen/Eigenvalues>

namespace cdfr {

Eigen::Vector3d PlaneMeeting::point(double least_share, int& rank) const {
  // Householder reduction and QR steps, without the closed form's arc functions, whose bits a C library
  // decides.
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(square_);
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  rank = 0;
  for (Eigen::Index i = 0; i < 3; ++i) {
    const double value = solver.eigenvalues()[i];
    if (!(value > least_share * count_)) continue;
    ++rank;
    const Eigen::Vector3d axis = solver.eigenvectors().col(i);
    point += axis * (axis.dot(right_) / value);
  }
  return point;
}

}  // namespace cdfr
