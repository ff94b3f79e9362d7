#include "cdfr/mesh/flip.h"

#include "mesh/flip_triangles.h"

namespace cdfr {

void flip(Mesh& mesh) noexcept { flip_triangles(mesh.triangles); }

}  // namespace cdfr
