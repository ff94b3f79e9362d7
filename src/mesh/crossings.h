/// Exact winding by counting where a ray leaves and enters.
#pragma once

#include "cdfr/core/types.h"
#include "mesh/bvh.h"

namespace cdfr {

/// How often a closed mesh winds around p: crossings of a segment from p to a point outside the mesh's box,
/// leaving counted 1, entering -1. Every crossing is decided by exact predicates; a segment that meets an
/// edge, a vertex or a triangle's plane is given up for the next of several directions. Precondition: p is
/// not on the surface.
int winding_by_crossings(const Vec3& p, SearchSpace space) noexcept;

}  // namespace cdfr
