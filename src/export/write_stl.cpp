
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>

#include "core/vector.h"
#include "export/little_endian.h"
#include "export/mesh_formats.h"

namespace cdfr {
namespace {

// Not "solid ...": by that word readers tell the ASCII form.
constexpr std::string_view title = "cdfr binary STL, float32";
constexpr std::size_t header_bytes = 80;

/// Zero for a triangle without area, as readers expect. Edges are brought to size 1 first, so that products
/// of very small or large ones neither vanish nor overflow.
Eigen::Vector3d unit_normal(const std::array<Eigen::Vector3d, 3>& corners) {
  Eigen::Vector3d first = corners[1] - corners[0];
  Eigen::Vector3d second = corners[2] - corners[0];
  const double size = std::max(first.cwiseAbs().maxCoeff(), second.cwiseAbs().maxCoeff());
  if (size == 0) return Eigen::Vector3d::Zero();
  first /= size;
  second /= size;
  const Eigen::Vector3d normal = first.cross(second);
  const double length = normal.norm();
  return length > 0 ? Eigen::Vector3d(normal / length) : Eigen::Vector3d::Zero();
}

template <std::size_t capacity>
void append(Record<capacity>& record, const Eigen::Vector3d& v) {
  for (const double coordinate : v) record.append(static_cast<float>(coordinate));
}

Result<void> check_range(MeshView mesh) {
  constexpr double limit = std::numeric_limits<float>::max();
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    if (to_eigen(mesh.vertices[i]).cwiseAbs().maxCoeff() <= limit) continue;
    return Error{
        Code::out_of_range, i,
        "vertex " + std::to_string(i) + " is beyond the float32 of an STL file; PLY and OBJ hold doubles"};
  }
  return {};
}

}  // namespace

Result<void> write_stl(MeshView mesh, WholeFile& file) {
  if (auto checked = check_range(mesh); !checked) return checked;
  std::string header(title);
  header.resize(header_bytes, '\0');
  if (auto written = file.write(header); !written) return written;
  Record<4> count;
  count.append(static_cast<std::uint32_t>(mesh.triangles.size()));
  if (auto written = file.write(count.bytes()); !written) return written;

  for (const Triangle& triangle : mesh.triangles) {
    std::array<Eigen::Vector3d, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) corners[k] = to_eigen(mesh.vertices[triangle[k]]);
    Record<50> record;
    append(record, unit_normal(corners));
    for (const Eigen::Vector3d& corner : corners) append(record, corner);
    record.append(std::uint16_t{0});
    if (auto written = file.write(record.bytes()); !written) return written;
  }
  return {};
}

}  // namespace cdfr
