#include "export/writable_mesh.h"

#include <cmath>
#include <cstdint>
#include <string>

namespace cdfr {

Result<void> check_writable(MeshView mesh) {
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

}  // namespace cdfr
