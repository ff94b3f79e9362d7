#include <cstdint>
#include <string>

#include "export/mesh_formats.h"
#include "export/number_text.h"

namespace cdfr {
namespace {

void set_vertex_line(std::string& line, Vec3 v) {
  line.assign(1, 'v');
  for (const double coordinate : {v.x, v.y, v.z}) {
    line += ' ';
    append_number(line, coordinate);
  }
  line += '\n';
}

void append_face_line(std::string& line, const Triangle& triangle) {
  line += 'f';
  for (const std::uint32_t corner : triangle) {
    line += ' ';
    append_number(line, std::uint64_t{corner} + 1);
  }
  line += '\n';
}

}  // namespace

Result<void> write_obj(MeshView mesh, WholeFile& file) {
  if (auto written = file.write("# written by cdfr\n"); !written) return written;
  std::string line;
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    set_vertex_line(line, mesh.vertices[i]);
    if (auto written = file.write(line); !written) return written;
  }
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    line.clear();
    if (!mesh.patches.empty() && (i == 0 || mesh.patches[i] != mesh.patches[i - 1])) {
      line += "g patch_";
      append_number(line, mesh.patches[i]);
      line += '\n';
    }
    append_face_line(line, mesh.triangles[i]);
    if (auto written = file.write(line); !written) return written;
  }
  return {};
}

}  // namespace cdfr
