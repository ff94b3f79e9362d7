/// One order of vertices, so that what is computed from several does not depend on how they are listed.
#pragma once

#include "cdfr/core/types.h"

namespace cdfr {

/// By x, then y, then z; -0 equals 0. Without branches: nobody could foretell them.
inline bool precedes(const Vec3& a, const Vec3& b) noexcept {
  const unsigned last = unsigned{a.z < b.z};
  const unsigned later = unsigned{a.y < b.y} | (unsigned{a.y == b.y} & last);
  return (unsigned{a.x < b.x} | (unsigned{a.x == b.x} & later)) != 0;
}

}  // namespace cdfr
