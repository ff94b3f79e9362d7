#include "mesh/triangles.h"

#include <tbb/parallel_for.h>

#include "geometry/unit_normal.h"

namespace cdfr {
namespace {

void place(TriangleStore& store, std::size_t slot, const std::array<Vec3, 3>& corners,
           const DoubleDouble3& normal) {
  TriangleGroup& group = store.groups[slot / group_size];
  const std::size_t lane = slot % group_size;
  for (int corner = 0; corner < 3; ++corner) {
    const Vec3& v = corners[corner];
    const double xyz[3] = {v.x, v.y, v.z};
    for (int axis = 0; axis < 3; ++axis) group.vertices[corner][axis][lane] = xyz[axis];
  }
  for (int axis = 0; axis < 3; ++axis) group.normals[axis][lane] = normal[axis].hi;
}

}  // namespace

TriangleStore gather_triangles(MeshView mesh, const Topology& topology,
                               const std::vector<std::uint32_t>& order) {
  TriangleStore store;
  const std::size_t count = order.size();
  store.groups.resize((count + group_size - 1) / group_size);
  store.records.resize(count);
  tbb::parallel_for(std::size_t{0}, store.groups.size(), [&](std::size_t g) {
    for (std::size_t slot = g * group_size; slot < (g + 1) * group_size; ++slot) {
      const std::uint32_t number = order[slot < count ? slot : count - 1];
      const Triangle& t = mesh.triangles[number];
      const std::array<Vec3, 3> corners{mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]};
      const DoubleDouble3 normal = unit_normal(corners[0], corners[1], corners[2]);
      place(store, slot, corners, normal);
      if (slot >= count) continue;
      store.records[slot] = {{normal[0].lo, normal[1].lo, normal[2].lo},
                             topology.triangles[number],
                             topology.edges_of[number],
                             number,
                             mesh.patches.empty() ? 0 : mesh.patches[number],
                             Sides::unknown,
                             {}};
    }
  });
  return store;
}

}  // namespace cdfr
