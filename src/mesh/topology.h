/// Which triangles share which edges and vertices, after vertices of equal coordinates are taken as one.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "cdfr/mesh/mesh.h"
#include "core/scratch.h"

namespace cdfr {

struct Topology {
  /// One use of an edge by a triangle. `forward`: the triangle runs from the edge's low vertex to its high
  /// one.
  struct Use {
    std::uint32_t triangle = 0;
    bool forward = false;
  };
  struct Edge {
    std::array<std::uint32_t, 2> vertices{};  ///< welded vertex ids, ascending
    std::uint64_t first_use = 0;              ///< its uses are uses[first_use] .. of the next edge
  };

  Topology() = default;
  explicit Topology(const Scratch* scratch)
      : triangles(scratch), edges_of(scratch), edges(scratch), uses(scratch) {}

  Large<Triangle> triangles;  ///< welded: every corner is an id in 0 .. vertex_count - 1
  Large<Triangle> edges_of;   ///< edge ids; edge k of a triangle joins its corners k and (k + 1) % 3
  Large<Edge> edges;  ///< sorted by vertices; a collapsed edge (v, v) is no edge: no_index in edges_of
  Large<Use> uses;    ///< grouped by edge, ascending by triangle
  std::uint32_t vertex_count = 0;

  /// True if two corners are equal: the triangle has no place among the edges.
  bool collapsed(std::size_t triangle) const noexcept {
    const Triangle& t = triangles[triangle];
    return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
  }

  /// 3 * triangle + k, where corner k is that vertex. Precondition: the triangle has it.
  std::size_t corner_of(std::uint32_t triangle, std::uint32_t vertex) const noexcept {
    const Triangle& t = triangles[triangle];
    return 3 * std::size_t{triangle} + (t[0] == vertex ? 0U : t[1] == vertex ? 1U : 2U);
  }

  std::span<const Use> uses_of(std::uint32_t edge) const noexcept {
    const std::uint64_t end = edge + 1 < edges.size() ? edges[edge + 1].first_use : uses.size();
    return std::span<const Use>(uses).subspan(edges[edge].first_use, end - edges[edge].first_use);
  }
};

/// Precondition: indices are in range and coordinates finite. Welded ids are numbered by first use in
/// triangle order. O(n log n), deterministic.
Topology weld_topology(MeshView mesh, const Scratch* scratch = nullptr);

}  // namespace cdfr
