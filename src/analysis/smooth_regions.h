/// Smooth regions: triangles joined over edges of the tessellation. Design edges part them.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "analysis/triangle_edges.h"
#include "mesh/triangles.h"

namespace cdfr {

/// How an edge bends, seen from in front of its triangles.
enum class Bend : std::uint8_t { convex, concave };

/// Angle in degrees between the normals of two triangles that run along their common edge in opposite
/// directions; 180, so that no tessellation has it, if they do not or if one has no area.
double turn_in_degrees(const TriangleStore& triangles, TriangleSide a, TriangleSide b) noexcept;

class SmoothRegions {
 public:
  /// An edge is smooth if two triangles have it, no more, and it turns by at most `sharp` degrees. `bend` is
  /// that of the design edges that adjoin() and at_edge() ask for. O(n log n).
  SmoothRegions(const TriangleStore& triangles, const TriangleEdges& edges, double sharp, Bend bend);

  std::uint32_t count() const noexcept { return count_; }
  /// By slot; numbered by first slot.
  std::uint32_t region(std::uint32_t slot) const noexcept { return regions_[slot]; }
  /// Do two regions meet at a design edge of that bend? Never one with itself: a crease that ends within a
  /// region says nothing of walls elsewhere in it.
  bool adjoin(std::uint32_t a, std::uint32_t b) const noexcept;
  /// Does a design edge of that bend end at this welded vertex?
  bool at_edge(std::uint32_t vertex) const noexcept { return at_edge_[vertex] != 0; }

 private:
  void join(const TriangleStore& triangles, const TriangleEdges& edges, double sharp);
  void note_design_edge(const TriangleStore& triangles, std::span<const TriangleSide> sides, Bend bend);

  std::uint32_t count_ = 0;
  std::vector<std::uint32_t> regions_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> adjoining_;  ///< sorted, the lower one first
  std::vector<std::uint8_t> at_edge_;
};

}  // namespace cdfr
