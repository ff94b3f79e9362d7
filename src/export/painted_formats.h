/// The formats of write_painted beside PLY (mesh_formats.h). Each appends what was checked before; the caller
/// creates and finishes the file.
#pragma once

#include "cdfr/core/result.h"
#include "cdfr/export/painted.h"
#include "core/whole_file.h"

namespace cdfr {

/// ParaView's XML PolyData, arrays appended as raw little endian bytes.
Result<void> write_vtp(const PaintedMesh& painted, WholeFile& file);

/// Whether it could fit in a GLB, by its counts alone. Error: file_write.
Result<void> check_glb_size(const PaintedMesh& painted);

/// Errors: out_of_range (too large or small in metres), file_write (4 GiB).
/// Precondition: metres_per_unit is finite and positive.
Result<void> write_glb(const PaintedMesh& painted, double metres_per_unit, WholeFile& file);

}  // namespace cdfr
