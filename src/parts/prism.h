/// What the extruded parts share: the wall between two rings of corners.
#pragma once

#include <cstdint>

#include "cdfr/mesh/mesh.h"

namespace cdfr {

/// Two triangles for each side of a ring of `count` corners. The rings start at vertices `low` and `high`;
/// seen from the high ring they run counter-clockwise around the inside.
void add_wall(Mesh& mesh, std::uint32_t low, std::uint32_t high, std::uint32_t count);

}  // namespace cdfr
