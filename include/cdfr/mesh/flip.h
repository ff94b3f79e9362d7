/// A mesh turned inside out, or back.
#pragma once

#include "cdfr/core/api.h"
#include "cdfr/mesh/mesh.h"

namespace cdfr {

/// Exchanges the second and third corner of every triangle, so that front and back change places; element
/// numbers and barycentric coordinates of answers go by that order. O(triangles).
CDFR_API void flip(Mesh& mesh) noexcept;

}  // namespace cdfr
