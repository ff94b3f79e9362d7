/// The same surface without its triangles of no area.
#pragma once

#include <optional>

#include "cdfr/mesh/mesh.h"
#include "soak/welded.h"

namespace cdfr::soak {

/// Every triangle of no area is flipped with its neighbour over its longest edge, the longest first. None if
/// that would use an edge more than once each way. Precondition: `mesh` is welded
/// and closed, with these edges.
std::optional<Mesh> without_flat_triangles(const Mesh& mesh, const DirectedEdges& edges);

}  // namespace cdfr::soak
