/// The formats of write_mesh. Each appends a mesh that was checked before; the caller creates and finishes
/// the file.
#pragma once

#include "cdfr/core/result.h"
#include "cdfr/export/painted.h"
#include "cdfr/mesh/mesh.h"
#include "core/whole_file.h"

namespace cdfr {

/// Binary STL. It stores float32 and neither patches nor shared vertices. Error: out_of_range for a
/// coordinate beyond float32.
Result<void> write_stl(MeshView mesh, WholeFile& file);

/// Binary little endian PLY: double coordinates, uint indices, the arrays, `uint patch` a face if there are
/// patches, and colours if an array is painted.
Result<void> write_ply(const PaintedMesh& painted, WholeFile& file);

/// OBJ, with a `g patch_ID` line wherever the patch changes, so that triangles keep their numbers.
Result<void> write_obj(MeshView mesh, WholeFile& file);

}  // namespace cdfr
