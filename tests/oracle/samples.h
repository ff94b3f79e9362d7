/// Points around a model where a tree, a kernel or a sign could go wrong.
#pragma once

#include <cstddef>
#include <vector>

#include "cdfr/field/field.h"
#include "cdfr/mesh/mesh.h"
#include "oracle/random.h"

namespace cdfr::oracle {

/// Takes turns: in the box grown by 1.2, near the surface, on vertices, on edges, inside triangles, on the
/// faces, edges, corners and mid-planes of the field's leaves, and 10 and 1000 boxes away. Any prefix has its
/// share of each.
std::vector<Vec3> model_points(Random& random, MeshView mesh, const Field& field, std::size_t count);

}  // namespace cdfr::oracle
