/// One part many times, for meshes as large as wanted.
#pragma once

#include <cstdint>
#include <string_view>

#include "cdfr/core/result.h"
#include "cdfr/mesh/mesh.h"

namespace cdfr {

/// As make_part says it. Precondition: the part has no patches, no more vertices than triangles, and starts
/// at x = 0. O(triangles in all), and no memory but the mesh's.
Result<Mesh> copied(Mesh part, std::string_view name, std::uint64_t copies);

}  // namespace cdfr
