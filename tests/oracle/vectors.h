/// The little vector algebra that the tests need to make their points. Nothing here decides an answer.
#pragma once

#include <algorithm>
#include <cmath>

#include "cdfr/core/types.h"

namespace cdfr::oracle {

inline Vec3 plus(Vec3 a, double t, Vec3 b) noexcept { return {a.x + t * b.x, a.y + t * b.y, a.z + t * b.z}; }
inline Vec3 minus(Vec3 a, Vec3 b) noexcept { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vec3 times(double t, Vec3 a) noexcept { return {t * a.x, t * a.y, t * a.z}; }
inline double dot(Vec3 a, Vec3 b) noexcept { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec3 cross(Vec3 a, Vec3 b) noexcept {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double length(Vec3 a) noexcept { return std::sqrt(dot(a, a)); }

}  // namespace cdfr::oracle
