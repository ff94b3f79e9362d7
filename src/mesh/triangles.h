/// The mesh as queries want it: groups of eight in BVH order, and what belongs to each triangle beside its
/// shape.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "cdfr/core/types.h"
#include "geometry/point_triangle.h"
#include "geometry/triangle_group.h"
#include "mesh/topology.h"

namespace cdfr {

/// Where the two sides of a triangle lie, if all of it agrees: `outward` is in front outside, behind inside.
enum class Sides : std::uint8_t { unknown, outward, both_inside, both_outside };

/// What a query needs of a triangle only after it may have won.
struct TriangleRecord {
  Vec3 normal_rest;                       ///< low part of the double-double unit normal
  std::array<std::uint32_t, 3> vertices;  ///< welded vertex ids
  std::array<std::uint32_t, 3> edges;     ///< edge ids; no_index for a collapsed edge
  std::uint32_t number;                   ///< place in the input
  std::uint32_t patch;
  Sides sides;
  std::array<std::uint8_t, 7> zero;  ///< to 64 bytes, written to files
};
static_assert(sizeof(TriangleRecord) == 64);

/// A slot is a place in BVH order: lane slot % 8 of group slot / 8.
struct TriangleStore {
  std::vector<TriangleGroup> groups;
  std::vector<TriangleRecord> records;  ///< by slot

  std::uint32_t size() const noexcept { return static_cast<std::uint32_t>(records.size()); }
  /// Lanes of a group that hold a triangle of their own.
  std::size_t lanes(std::uint32_t group) const noexcept {
    const std::size_t left = records.size() - std::size_t{group} * group_size;
    return left < group_size ? left : group_size;
  }
  /// Calls for the lines that shape and record read.
  void prefetch(std::uint32_t slot) const noexcept {
    const TriangleGroup& g = groups[slot / group_size];
    for (const auto& corner : g.vertices) {
      for (const auto& axis : corner) __builtin_prefetch(axis);
    }
    for (const auto& axis : g.normals) __builtin_prefetch(axis);
    __builtin_prefetch(&records[slot]);
  }
  TriangleShape shape(std::uint32_t slot) const noexcept {
    const TriangleGroup& g = groups[slot / group_size];
    const std::size_t lane = slot % group_size;
    const Vec3 hi = g.normal(lane);
    const Vec3& lo = records[slot].normal_rest;
    return {{g.vertex(0, lane), g.vertex(1, lane), g.vertex(2, lane)},
            {DoubleDouble{hi.x, lo.x}, DoubleDouble{hi.y, lo.y}, DoubleDouble{hi.z, lo.z}}};
  }
};

/// Shapes and records by slot: `order` gives the triangles' numbers.
TriangleStore gather_triangles(MeshView mesh, const Topology& topology,
                               const std::vector<std::uint32_t>& order);

}  // namespace cdfr
