/// Meshes and points as files that other programs read.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "cdfr/core/api.h"
#include "cdfr/core/result.h"
#include "cdfr/core/sinks.h"
#include "cdfr/mesh/mesh.h"

namespace cdfr {

/// Writes the mesh; the extension names the format: .stl (binary, float32), .ply (binary little endian, double),
/// .obj (17 digits). Written to a temporary file, synced, renamed. Errors: bad_option (extension), file_write.
CDFR_API Result<void> write_mesh(MeshView mesh, const std::filesystem::path& path);

/// A file that takes points as they come. Nothing is at `path` until finish() has returned without an error.
class CDFR_API PointFile : public PointSink {
 public:
  /// Patches counts, syncs and renames. Call once, last; without it the destructor removes the temporary file.
  virtual Result<void> finish() = 0;
};

/// The extension names the format: .ply (binary little endian: x y z nx ny nz error double, triangle uint),
/// .csv (x,y,z,nx,ny,nz,triangle,error, 17 digits), .glb (POINTS, float32 relative to a node translation, scaled by
/// `metres_per_unit`, for looking). Errors: bad_option (extension), file_write.
CDFR_API Result<std::unique_ptr<PointFile>> create_point_file(const std::filesystem::path& path,
                                                              double metres_per_unit = 1);

}  // namespace cdfr
