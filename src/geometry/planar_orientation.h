/// Exact signs in the plane: on which side of a line a point lies once a coordinate is left out.
#pragma once

#include "cdfr/core/types.h"

namespace cdfr {

/// Sign of component `axis` (0, 1 or 2) of (b - a) x (c - a): the turn from a over b to c, seen along that
/// axis. 0 exactly if the projections lie on one line. Preconditions: axis is 0 to 2, coordinates as in
/// query_range.h. A double-precision filter answers nearly always, else expansions do. Source: Shewchuk 1997,
/// orient2d.
int planar_orientation(const Vec3& a, const Vec3& b, const Vec3& c, int axis) noexcept;

}  // namespace cdfr
