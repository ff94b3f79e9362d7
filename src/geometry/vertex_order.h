/// One order of vertices, so that what is computed from several does not depend on how they are listed.
#pragma once

#include <tuple>

#include "cdfr/core/types.h"

namespace cdfr {

/// By x, then y, then z; -0 equals 0.
inline bool precedes(const Vec3& a, const Vec3& b) noexcept {
  return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
}

}  // namespace cdfr
