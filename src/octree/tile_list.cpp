#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "core/vector.h"
#include "octree/tile_scan.h"

namespace cdfr {
namespace {

using Eigen::Vector3d;

TileTriangle::Axis axis(const Vector3d& way, const Vector3d& from) {
  return {{static_cast<float>(way[0]), static_cast<float>(way[1]), static_cast<float>(way[2])},
          static_cast<float>(way.dot(from))};
}

/// Where the area is zero, corners are on one line or all the same: any direction across it.
Vector3d normal_across(const Vector3d (&edges)[3]) {
  const Vector3d* longest = std::max_element(edges, edges + 3, [](const Vector3d& a, const Vector3d& b) {
    return a.squaredNorm() < b.squaredNorm();
  });
  return longest->squaredNorm() > 0 ? longest->unitOrthogonal() : Vector3d(Vector3d::UnitZ());
}

/// The triangle from `middle`, which is in edges from the lattice's origin. Its edges are differences of
/// corners as they are given: of corners seen from the middle, small ones would lose digits.
TileTriangle seen_from(const TriangleShape& shape, const Lattice& lattice, const Vector3d& middle,
                       double radius) {
  const double scale = 1 / lattice.edge;  // exact: a power of two
  Vector3d corners[3], from[3], edges[3];
  double farthest = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    corners[k] = to_eigen(shape.vertices[k]);
    from[k] = (corners[k] - to_eigen(lattice.origin)) * scale - middle;
    farthest = std::max(farthest, from[k].squaredNorm());
  }
  for (std::size_t k = 0; k < 3; ++k) edges[k] = (corners[(k + 1) % 3] - corners[k]) * scale;
  Vector3d n = to_eigen(rounded(shape.normal));
  const bool has_area = !n.isZero(0);
  if (!has_area) n = normal_across(edges);
  TileTriangle t;
  for (std::size_t k = 0; k < 3; ++k) {
    const double length = edges[k].norm();
    const Vector3d along = length > 0 ? Vector3d(edges[k] / length) : n.unitOrthogonal();
    t.edges[k] = {axis(along, from[k]), axis(n.cross(along), from[k]), static_cast<float>(length)};
  }
  t.height = axis(n, from[0]);
  t.doubt = has_area ? tile_doubt * static_cast<float>(std::sqrt(farthest) + radius)
                     : std::numeric_limits<float>::infinity();
  return t;
}

}  // namespace

bool TileList::fill(const TriangleStore& all, const Lattice& lattice, std::span<const Entry> list,
                    const Vec3& middle, double radius) {
  store = &all;
  triangles.clear();
  slots.clear();
  float longest = 0;
  for (const Entry& entry : list) {
    if (!entry.is_group()) return false;
    for (unsigned lanes = entry.lanes(); lanes != 0; lanes &= lanes - 1) {
      const auto lane = static_cast<std::uint32_t>(std::countr_zero(lanes));
      const std::uint32_t slot = entry.number() * static_cast<std::uint32_t>(group_size) + lane;
      triangles.push_back(seen_from(all.shape(slot), lattice, to_eigen(middle), radius));
      slots.push_back(slot);
      for (const TileTriangle::Edge& edge : triangles.back().edges) longest = std::max(longest, edge.length);
    }
    if (triangles.size() > most) return false;
  }
  reach = (longest + static_cast<float>(radius)) * (1 + tile_error);
  return true;
}

}  // namespace cdfr
