/// Exact signs: on which side of a plane a point lies.
#pragma once

#include "cdfr/core/types.h"

namespace cdfr {

/// Sign of ((b - a) x (c - a)) . (p - a): 1 on the side the normal of a, b, c points to, 0 exactly on the
/// plane. A double-precision filter answers nearly always, else expansions do. Source: Shewchuk 1997,
/// orient3d.
int orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p) noexcept;

}  // namespace cdfr
