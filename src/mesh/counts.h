/// What can be counted of a mesh from its topology and corners alone.
#pragma once

#include <cstdint>
#include <span>

#include "cdfr/mesh/audit.h"
#include "core/scratch.h"
#include "mesh/topology.h"
#include "mesh/twins.h"

namespace cdfr {

/// All of the report but touching triangles and turned shells. Precondition: `topology` is the mesh's. O(n
/// log n).
MeshReport counted(MeshView mesh, const Topology& topology, std::span<const std::uint32_t> first_twins,
                   const Scratch* scratch = nullptr);

/// Of the corners that triangles use; lo > hi if there are none.
Box box_of(const MeshView& mesh) noexcept;

}  // namespace cdfr
