/// A mesh as the checks and the points see it: vertices of equal coordinates are one, collapsed triangles are
/// gone, and what is left is closed.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cdfr/mesh/mesh.h"

namespace cdfr::soak {

/// From (tail, head) to the triangle that runs along it.
using DirectedEdges = std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t>;

/// Keeps the order of what it keeps. Patches are dropped.
Mesh welded(const Mesh& mesh);

/// None if a directed edge is used twice or one way only: not closed, not oriented or not a manifold.
std::optional<DirectedEdges> closed_edges(const std::vector<Triangle>& triangles);

/// Largest absolute coordinate.
double largest_coordinate(const Mesh& mesh) noexcept;

}  // namespace cdfr::soak
