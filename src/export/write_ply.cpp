#include <cstdint>
#include <string>

#include "export/little_endian.h"
#include "export/mesh_formats.h"
#include "export/number_text.h"
#include "export/paint.h"
#include "export/text_line.h"

namespace cdfr {
namespace {

/// The columns that vertices or triangles have beside their own.
void append_columns(const PaintedMesh& painted, ArrayPlace place, std::string& header) {
  for (const MeshArray& array : painted.arrays) {
    if (array.place == place) header += "property double " + array.name + "\n";
  }
  if (Paint(painted).on(place)) header += "property uchar red\nproperty uchar green\nproperty uchar blue\n";
}

std::string header_of(const PaintedMesh& painted) {
  std::string text = "ply\nformat binary_little_endian 1.0\ncomment written by cdfr\n";
  if (Paint(painted).any()) text += "comment painted: " + range_text(painted) + "\n";
  for (const std::string& note : painted.notes) text += "comment " + text_line(note) + "\n";
  text += "element vertex ";
  append_number(text, painted.mesh.vertices.size());
  text += "\nproperty double x\nproperty double y\nproperty double z\n";
  append_columns(painted, ArrayPlace::vertex, text);
  text += "element face ";
  append_number(text, painted.mesh.triangles.size());
  text += "\nproperty list uchar uint vertex_indices\n";
  if (!painted.mesh.patches.empty()) text += "property uint patch\n";
  append_columns(painted, ArrayPlace::face, text);
  return text + "end_header\n";
}

Result<void> write_columns(const PaintedMesh& painted, const Paint& paint, ArrayPlace place, std::size_t i,
                           WholeFile& file) {
  for (const MeshArray& array : painted.arrays) {
    if (array.place != place) continue;
    Record<8> value;
    value.append(array.values[i]);
    if (auto written = file.write(value.bytes()); !written) return written;
  }
  if (!paint.on(place)) return {};
  Record<3> colour;
  for (const std::uint8_t channel : paint.colour(i)) colour.append(channel);
  return file.write(colour.bytes());
}

}  // namespace

Result<void> write_ply(const PaintedMesh& painted, WholeFile& file) {
  const MeshView& mesh = painted.mesh;
  const Paint paint(painted);
  if (auto written = file.write(header_of(painted)); !written) return written;
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    const Vec3 v = mesh.vertices[i];
    Record<24> record;
    for (const double coordinate : {v.x, v.y, v.z}) record.append(coordinate);
    if (auto written = file.write(record.bytes()); !written) return written;
    if (auto written = write_columns(painted, paint, ArrayPlace::vertex, i, file); !written) return written;
  }
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    Record<17> record;
    record.append(std::uint8_t{3});
    for (const std::uint32_t corner : mesh.triangles[i]) record.append(corner);
    if (!mesh.patches.empty()) record.append(mesh.patches[i]);
    if (auto written = file.write(record.bytes()); !written) return written;
    if (auto written = write_columns(painted, paint, ArrayPlace::face, i, file); !written) return written;
  }
  return {};
}

}  // namespace cdfr
