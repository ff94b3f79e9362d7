/// What every writer of meshes asks first.
#pragma once

#include "cdfr/core/result.h"
#include "cdfr/mesh/mesh.h"

namespace cdfr {

/// A file that this library's own reader would refuse is not written. Errors: bad_option (patches),
/// out_of_range (more than 2^32 - 2 triangles or vertices), not_finite, bad_index; counts are looked at
/// before coordinates.
Result<void> check_writable(MeshView mesh);

}  // namespace cdfr
