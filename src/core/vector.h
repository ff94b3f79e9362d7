/// Between the public plain values and Eigen, which does the vector algebra inside.
#pragma once

#include <Eigen/Core>

#include "cdfr/core/types.h"

namespace cdfr {

inline Eigen::Vector3d to_eigen(const Vec3& v) noexcept { return {v.x, v.y, v.z}; }
inline Vec3 from_eigen(const Eigen::Vector3d& v) noexcept { return {v.x(), v.y(), v.z()}; }

}  // namespace cdfr
