/// What can be counted of a mesh from its topology and corners alone.
#pragma once

#include "cdfr/mesh/audit.h"
#include "mesh/topology.h"

namespace cdfr {

/// All of the report but touching triangles and turned shells. Precondition: `topology` is the mesh's. O(n
/// log n).
MeshReport counted(MeshView mesh, const Topology& topology);

}  // namespace cdfr
