/// The same surface without its triangles of no area.
#pragma once

#include <optional>

#include "cdfr/mesh/mesh.h"

namespace cdfr::soak {

/// Every triangle of no area is flipped with its neighbour over its longest edge, the longest first. None if
/// that would use an edge more than once each way. Precondition: `mesh` is welded and closed.
std::optional<Mesh> without_flat_triangles(const Mesh& mesh);

}  // namespace cdfr::soak
