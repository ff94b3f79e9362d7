/// The made parts by name. Each is closed, embedded, outward oriented, and shares its vertices between
/// triangles.
#pragma once

#include "cdfr/mesh/mesh.h"

namespace cdfr {

Mesh cube();
Mesh tetrahedron();
Mesh one_tooth();
Mesh two_ended_tooth();
Mesh six_star();
Mesh connector();
Mesh brevi();
Mesh cylinder_head();
Mesh engine();

}  // namespace cdfr
