#include <string>

#include "cdfr/export/painted.h"
#include "cdfr/export/write.h"
#include "core/whole_file.h"
#include "export/extension.h"
#include "export/mesh_formats.h"
#include "export/writable_mesh.h"

namespace cdfr {
namespace {

Result<void> write_plain_ply(MeshView mesh, WholeFile& file) { return write_ply(PaintedMesh{mesh}, file); }

}  // namespace

Result<void> write_mesh(MeshView mesh, const std::filesystem::path& path) {
  const std::string format = format_of(path);
  const auto write = format == ".stl"   ? &write_stl
                     : format == ".ply" ? &write_plain_ply
                     : format == ".obj" ? &write_obj
                                        : nullptr;
  if (write == nullptr) {
    return Error{Code::bad_option, 0, "a mesh is written as .stl, .ply or .obj, not as '" + format + "'"};
  }
  if (auto checked = check_writable(mesh); !checked) return checked;
  auto file = WholeFile::create(path);
  if (!file) return file.error();
  if (auto written = write(mesh, *file); !written) return written;
  return file->finish();
}

}  // namespace cdfr
