/// What a mesh is before anyone measures to it: closed, oriented, degenerate, duplicated.
#pragma once

#include <cstdint>
#include <string>

#include "cdfr/core/api.h"
#include "cdfr/core/result.h"
#include "cdfr/mesh/mesh.h"

namespace cdfr {

/// Counts after vertices of equal coordinates are taken as one (-0 equals 0); the mesh itself is not changed.
struct MeshReport {
  std::uint64_t triangles = 0;
  std::uint64_t vertices = 0;            ///< distinct positions that triangles use
  std::uint64_t open_edges = 0;          ///< edges with one triangle
  std::uint64_t nonmanifold_edges = 0;   ///< edges with three or more triangles
  std::uint64_t flipped_edges = 0;       ///< edges whose two triangles run along them in the same direction
  std::uint64_t nonmanifold_vertices = 0;  ///< vertices whose triangles form more than one fan
  std::uint64_t degenerate_triangles = 0;  ///< area exactly zero
  std::uint64_t duplicate_triangles = 0;   ///< same three positions as an earlier triangle, in any order
  std::uint64_t components = 0;          ///< connected through shared edges
  double volume = 0;                     ///< signed, by the divergence theorem; positive if normals point outward
  double area = 0;
  Box box;

  /// Every edge has two triangles that run along it in opposite directions. Inside out if the volume is negative.
  bool closed() const noexcept {
    return triangles > 0 && open_edges == 0 && nonmanifold_edges == 0 && flipped_edges == 0;
  }
};

/// Errors: bad_index, not_finite, out_of_range, empty_mesh (with `where` the triangle or vertex). O(n log n); thread safe.
CDFR_API Result<MeshReport> audit(MeshView mesh);

}  // namespace cdfr
