/// The way from one point to another, rounded.
#pragma once

#include "cdfr/core/types.h"

namespace cdfr {

/// Each component within u of itself.
inline Vec3 minus(const Vec3& a, const Vec3& b) noexcept { return {a.x - b.x, a.y - b.y, a.z - b.z}; }

}  // namespace cdfr
