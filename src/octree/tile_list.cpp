#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "octree/tile_scan.h"

namespace cdfr {
namespace {

void set_edge(TileTriangle::Edge& edge, const float (&from)[3], const float (&to)[3],
              const float (&normal)[3]) {
  float length = 0, size = 0;
  for (int axis = 0; axis < 3; ++axis) {
    edge.along[axis] = to[axis] - from[axis];
    length += edge.along[axis] * edge.along[axis];
    size += std::fabs(edge.along[axis]);
  }
  edge.length = length;
  edge.over = 1 / std::max(length, std::numeric_limits<float>::min());
  const auto& e = edge.along;
  edge.inwards[0] = normal[1] * e[2] - normal[2] * e[1];
  edge.inwards[1] = normal[2] * e[0] - normal[0] * e[2];
  edge.inwards[2] = normal[0] * e[1] - normal[1] * e[0];
  edge.doubt = 16 * 0x1p-24F * size;
}

float size_of(const TileTriangle::Edge& edge) {
  return std::fabs(edge.along[0]) + std::fabs(edge.along[1]) + std::fabs(edge.along[2]);
}

void name_features(TileTriangle& triangle, const TriangleRecord& record) {
  for (std::size_t k = 0; k < 3; ++k) {
    triangle.features[k] = std::uint64_t{record.edges[k]} << 1;
    triangle.features[3 + k] = std::uint64_t{record.vertices[k]} << 1 | 1;
  }
}

/// The triangle from `middle`, which is in edges from the lattice's origin.
TileTriangle seen_from(const TriangleShape& shape, const Lattice& lattice,
                       const Vec3& middle) {
  TileTriangle t;
  float c[3];
  const double origin[3] = {lattice.origin.x, lattice.origin.y, lattice.origin.z};
  const double centre[3] = {middle.x, middle.y, middle.z};
  const double scale = 1 / lattice.edge;  // exact: a power of two
  for (int axis = 0; axis < 3; ++axis) {
    const auto seen = [&](int corner) {
      const Vec3& v = shape.vertices[corner];
      const double at[3] = {v.x, v.y, v.z};
      return static_cast<float>((at[axis] - origin[axis]) * scale - centre[axis]);
    };
    t.a[axis] = seen(0);
    t.b[axis] = seen(1);
    c[axis] = seen(2);
    t.normal[axis] = static_cast<float>(shape.normal[axis].hi);
  }
  set_edge(t.ab, t.a, t.b, t.normal);
  set_edge(t.bc, t.b, c, t.normal);
  set_edge(t.ca, t.a, c, t.normal);
  for (float& x : t.ca.inwards) x = -x;
  t.extent = std::max(size_of(t.ab), size_of(t.ca));
  return t;
}

}  // namespace

bool TileList::fill(const TriangleStore& store, const Lattice& lattice,
                    std::span<const Entry> list, const Vec3& middle, double radius) {
  triangles.clear();
  float longest = 0;
  for (const Entry& entry : list) {
    if (!entry.is_group()) return false;
    for (unsigned lanes = entry.lanes(); lanes != 0; lanes &= lanes - 1) {
      const auto lane = static_cast<std::uint32_t>(std::countr_zero(lanes));
      const std::uint32_t slot = entry.number() * static_cast<std::uint32_t>(group_size) + lane;
      triangles.push_back(seen_from(store.shape(slot), lattice, middle));
      TileTriangle& t = triangles.back();
      longest = std::max({longest, t.ab.length, t.bc.length, t.ca.length});
      t.slot = slot;
      name_features(t, store.records[slot]);
    }
    if (triangles.size() > most) return false;
  }
  reach = (std::sqrt(longest) + static_cast<float>(radius)) * (1 + tile_error);
  return true;
}

}  // namespace cdfr
