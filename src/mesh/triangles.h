/// The mesh as queries want it: triangles in BVH order, and what belongs to each beside its shape.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "cdfr/core/types.h"
#include "core/array.h"
#include "core/scratch.h"
#include "geometry/point_triangle.h"
#include "geometry/triangle_group.h"
#include "mesh/topology.h"

namespace cdfr {

/// Where the two sides of a triangle lie, if all of it agrees: `outward` is in front outside, behind inside.
enum class Sides : std::uint8_t { unknown, outward, both_inside, both_outside };

/// What the kernel reads of a triangle, on two cache lines of its own.
struct alignas(128) ExactTriangle {
  TriangleShape shape;
  std::uint32_t patch;
  std::uint32_t zero;  ///< to 128 bytes, written to files
};
static_assert(sizeof(ExactTriangle) == 128);

/// What a query needs of a triangle only after it may have won.
struct TriangleRecord {
  std::array<std::uint32_t, 3> vertices;  ///< welded vertex ids
  std::array<std::uint32_t, 3> edges;     ///< edge ids; no_index for a collapsed edge
  std::uint32_t number;                   ///< place in the input
  Sides sides;
  std::array<std::uint8_t, 3> zero;  ///< to 32 bytes, written to files
};
static_assert(sizeof(TriangleRecord) == 32);

/// A slot is a place in BVH order. Eight slots make a group: lane slot % 8 of group slot / 8.
struct TriangleStore {
  Array<ExactTriangle> exact;     ///< by slot
  Array<TriangleRecord> records;  ///< by slot

  std::uint32_t size() const noexcept { return static_cast<std::uint32_t>(records.size()); }
  std::size_t group_count() const noexcept { return (records.size() + group_size - 1) / group_size; }
  /// Lanes of a group that hold a triangle of their own.
  std::size_t lanes(std::uint32_t group) const noexcept {
    const std::size_t left = records.size() - std::size_t{group} * group_size;
    return left < group_size ? left : group_size;
  }
  /// The same as bits. No other lane may be looked at: there is nothing behind it.
  std::uint8_t own_lanes(std::uint32_t group) const noexcept {
    return static_cast<std::uint8_t>(0xffU >> (group_size - lanes(group)));
  }
  /// Calls for the lines that shape and record read.
  void prefetch(std::uint32_t slot) const noexcept {
    __builtin_prefetch(&exact[slot]);
    __builtin_prefetch(reinterpret_cast<const char*>(&exact[slot]) + 64);
    __builtin_prefetch(&records[slot]);
  }
  const TriangleShape& shape(std::uint32_t slot) const noexcept { return exact[slot].shape; }
  /// Copied side by side; lanes beyond the last triangle repeat it.
  TriangleGroup group(std::uint32_t number) const noexcept;
};

/// Shapes and records by slot: `order` gives the triangles' numbers.
TriangleStore gather_triangles(MeshView mesh, const Topology& topology, std::span<const std::uint32_t> order,
                               const Scratch* scratch = nullptr);

}  // namespace cdfr
