/// Whether a surface touches or crosses itself, as far as a query can see.
#pragma once

#include <cstdint>
#include <span>

#include "cdfr/core/types.h"
#include "cdfr/mesh/mesh.h"

namespace cdfr::oracle {

/// True if the point of the surface nearest to p lies on two triangles of the candidates that do not meet
/// there in a common corner or edge. Then the surface is not embedded, and which side p is on cannot be told
/// from it alone. Exact. The candidates must hold every triangle at the least distance, as Candidates::near
/// does.
bool touches_itself(MeshView mesh, Vec3 p, std::span<const std::uint32_t> candidates);

}  // namespace cdfr::oracle
