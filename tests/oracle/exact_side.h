/// Inside or outside of a closed mesh, decided by exact arithmetic alone.
#pragma once

#include <optional>

#include "cdfr/core/types.h"
#include "cdfr/mesh/mesh.h"

namespace cdfr::oracle {

/// How many times the surface winds around p: the crossings of a ray from p, counted +1 where it leaves
/// through a triangle's front and -1 where it enters. None if p lies exactly on a triangle. A ray that meets
/// an edge, a corner or a triangle's own plane exactly is not interpreted but replaced by one in another
/// direction. Precondition: closed mesh (every edge as often one way as the other), finite coordinates.
std::optional<int> exact_winding(MeshView closed_mesh, Vec3 p);

/// The ray's direction at each attempt, for tests that want to meet an edge at the first one: whole
/// coordinates below 2^20, not zero, and without a pattern that a part's edges could share.
Vec3 ray_direction(int attempt);

/// -1 inside (the winding number is not zero), +1 outside, 0 exactly on the surface.
int exact_side(MeshView closed_mesh, Vec3 p);

}  // namespace cdfr::oracle
