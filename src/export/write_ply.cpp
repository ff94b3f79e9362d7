#include <cstdint>
#include <string>

#include "export/little_endian.h"
#include "export/mesh_formats.h"
#include "export/number_text.h"

namespace cdfr {
namespace {

std::string header_of(MeshView mesh) {
  std::string text = "ply\nformat binary_little_endian 1.0\ncomment written by cdfr\nelement vertex ";
  append_number(text, mesh.vertices.size());
  text += "\nproperty double x\nproperty double y\nproperty double z\nelement face ";
  append_number(text, mesh.triangles.size());
  text += "\nproperty list uchar uint vertex_indices\n";
  if (!mesh.patches.empty()) text += "property uint patch\n";
  return text + "end_header\n";
}

}  // namespace

Result<void> write_ply(MeshView mesh, WholeFile& file) {
  if (auto written = file.write(header_of(mesh)); !written) return written;
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    const Vec3 v = mesh.vertices[i];
    Record<24> record;
    for (const double coordinate : {v.x, v.y, v.z}) record.append(coordinate);
    if (auto written = file.write(record.bytes()); !written) return written;
  }
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    Record<17> record;
    record.append(std::uint8_t{3});
    for (const std::uint32_t corner : mesh.triangles[i]) record.append(corner);
    if (!mesh.patches.empty()) record.append(mesh.patches[i]);
    if (auto written = file.write(record.bytes()); !written) return written;
  }
  return {};
}

}  // namespace cdfr
