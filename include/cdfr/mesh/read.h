/// Meshes from files: STL (binary, ASCII), OBJ, PLY (ASCII, binary of both endians), glTF and GLB.
#pragma once

#include <filesystem>
#include <vector>

#include "cdfr/core/api.h"
#include "cdfr/core/result.h"
#include "cdfr/mesh/mesh.h"

namespace cdfr {

/// Reads a mesh; the format is told by content, and by the name only where content cannot tell (OBJ).
/// Triangles are numbered in file order: polygons as fans from their first corner, glTF primitives in scene
/// order with node transforms applied. Patches are STL solids, OBJ groups (`g`, else `o`, else `usemtl`) and
/// glTF materials. Vertices are kept as the file has them: an STL has three a triangle.
///
/// The bytes are foreign: every size is checked against the file before memory is asked for; nothing outside
/// the file is opened (mtllib is ignored, a glTF's external URIs are refused), no image is decoded, the
/// locale is ignored. Errors: file_open (missing, or no regular file), file_format, file_truncated,
/// not_finite, bad_index, out_of_range. Error::text is one line with what and where (line or byte); it does
/// not repeat the file's name. Thread safe; O(bytes).
CDFR_API Result<Mesh> read_mesh(const std::filesystem::path& path);

/// Points from CSV (x,y,z with or without a header line; further columns are ignored), NPY ((n,3), f4 or f8,
/// C or Fortran order, little endian) or PLY (its vertices). `-` reads CSV from standard input. Errors as
/// read_mesh.
CDFR_API Result<std::vector<Vec3>> read_points(const std::filesystem::path& path);

}  // namespace cdfr
