/// Exact winding by counting where a ray leaves and enters.
#pragma once

#include <cstdint>
#include <optional>

#include "cdfr/core/types.h"
#include "mesh/bvh.h"

namespace cdfr {

/// How often a balanced mesh (MeshReport::balanced) winds around p: crossings of a ray from p, leaving
/// counted 1, entering -1. Every crossing is decided by exact predicates; a ray that meets an edge, a corner
/// or a triangle edge-on is given up for the next of a sequence of directions, no three of which lie in a
/// plane, so that an edge or a triangle spoils at most two. If 64 are spoilt, solid angles are added up
/// instead, which is right but within 2^-80 of an edge. Precondition: p is finite and within the range of
/// query_range.h; on the surface the result says nothing. O(sqrt n) as a rule.
int winding_by_crossings(const Vec3& p, SearchSpace space) noexcept;

/// The direction that is tried at that turn: (1, t, t^2).
Vec3 ray_direction(std::uint32_t attempt) noexcept;

/// The crossings of one ray from p, whether the mesh is balanced or not; nothing if the ray is spoilt.
std::optional<int> crossings_along(const Vec3& p, const Vec3& direction, SearchSpace space) noexcept;

/// The same as winding_by_crossings for a point just off the front (where the normal points) of a triangle
/// that has an area and that no other one meets but at shared edges and corners: the ray starts exactly on it
/// and does not count it.
int winding_in_front(std::uint32_t slot, SearchSpace space) noexcept;

}  // namespace cdfr
