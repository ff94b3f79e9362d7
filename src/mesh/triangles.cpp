#include "mesh/triangles.h"

#include <algorithm>
#include <utility>

#include "core/parallel.h"
#include "geometry/unit_normal.h"

namespace cdfr {

TriangleGroup TriangleStore::group(std::uint32_t number) const noexcept {
  TriangleGroup group;
  for (std::size_t lane = 0; lane < group_size; ++lane) {
    const TriangleShape& t = exact[std::min(std::size_t{number} * group_size + lane, exact.size() - 1)].shape;
    for (std::size_t corner = 0; corner < 3; ++corner) {
      group.vertices[corner][0][lane] = t.vertices[corner].x;
      group.vertices[corner][1][lane] = t.vertices[corner].y;
      group.vertices[corner][2][lane] = t.vertices[corner].z;
    }
    for (std::size_t axis = 0; axis < 3; ++axis) group.normals[axis][lane] = t.normal[axis].hi;
  }
  return group;
}

TriangleStore gather_triangles(MeshView mesh, const Topology& topology, std::span<const std::uint32_t> order,
                               const Scratch* scratch) {
  Large<ExactTriangle> exact(order.size(), scratch);
  Large<TriangleRecord> records(order.size(), scratch);
  constexpr std::size_t chunk = 1024;
  for_chunks(order.size(), chunk, [&](std::size_t first, std::size_t end) {
    for (std::size_t slot = first; slot < end; ++slot) {
      const std::uint32_t number = order[slot];
      const Triangle& t = mesh.triangles[number];
      const std::array<Vec3, 3> corners{mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]};
      exact[slot] = {{corners, unit_normal(corners[0], corners[1], corners[2])},
                     mesh.patches.empty() ? 0 : mesh.patches[number],
                     0};
      records[slot] = {topology.triangles[number], topology.edges_of[number], number, Sides::unknown, {}};
    }
  });
  return {std::move(exact), std::move(records)};
}

}  // namespace cdfr
