#include <cmath>
#include <cstdint>
#include <string>

#include "cdfr/export/write.h"
#include "core/whole_file.h"
#include "export/extension.h"
#include "export/mesh_formats.h"

namespace cdfr {
namespace {

/// A file that this library's own reader would refuse is not written.
Result<void> check(MeshView mesh) {
  if (!mesh.patches.empty() && mesh.patches.size() != mesh.triangles.size()) {
    return Error{Code::bad_option, mesh.patches.size(), "there must be one patch id a triangle, or none"};
  }
  if (mesh.triangles.size() >= no_index || mesh.vertices.size() >= no_index) {
    return Error{Code::out_of_range, 0, "a mesh has at most 2^32 - 2 triangles and vertices"};
  }
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    const Vec3 v = mesh.vertices[i];
    if (!std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z)) {
      return Error{Code::not_finite, i, "vertex " + std::to_string(i) + " is not finite"};
    }
  }
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (const std::uint32_t corner : mesh.triangles[i]) {
      if (corner < mesh.vertices.size()) continue;
      return Error{Code::bad_index, i,
                   "triangle " + std::to_string(i) + " names vertex " + std::to_string(corner) + " of " +
                       std::to_string(mesh.vertices.size())};
    }
  }
  return {};
}

}  // namespace

Result<void> write_mesh(MeshView mesh, const std::filesystem::path& path) {
  const std::string format = format_of(path);
  const auto write = format == ".stl"   ? &write_stl
                     : format == ".ply" ? &write_ply
                     : format == ".obj" ? &write_obj
                                        : nullptr;
  if (write == nullptr) {
    return Error{Code::bad_option, 0, "a mesh is written as .stl, .ply or .obj, not as '" + format + "'"};
  }
  if (auto checked = check(mesh); !checked) return checked;
  auto file = WholeFile::create(path);
  if (!file) return file.error();
  if (auto written = write(mesh, *file); !written) return written;
  return file->finish();
}

}  // namespace cdfr
