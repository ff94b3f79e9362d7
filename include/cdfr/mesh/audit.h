/// What a mesh is before anyone measures to it: closed, oriented, embedded, degenerate, duplicated.
#pragma once

#include <cstdint>
#include <string>

#include "cdfr/core/api.h"
#include "cdfr/core/result.h"
#include "cdfr/core/run.h"
#include "cdfr/mesh/mesh.h"
#include "cdfr/mesh/sign.h"

namespace cdfr {

/// Counts after vertices of equal coordinates are taken as one (-0 equals 0); the mesh itself is not changed.
struct MeshReport {
  std::uint64_t triangles = 0;
  std::uint64_t vertices = 0;           ///< distinct positions that triangles use
  std::uint64_t open_edges = 0;         ///< edges with one triangle
  std::uint64_t nonmanifold_edges = 0;  ///< edges with three or more triangles
  std::uint64_t flipped_edges = 0;      ///< edges whose two triangles run along them in the same direction
  std::uint64_t unbalanced_edges = 0;   ///< edges that triangles run along more often one way than the other
  std::uint64_t nonmanifold_vertices = 0;  ///< vertices whose triangles form more than one fan
  std::uint64_t degenerate_triangles = 0;  ///< area exactly zero
  std::uint64_t duplicate_triangles = 0;   ///< same three positions as an earlier triangle, in any order
  std::uint64_t touching_triangles =
      0;                         ///< cross or touch another one beyond the corners and edges they share
  std::uint64_t components = 0;  ///< connected through shared edges
  /// Shells whose front is not outside: turned inside out, or one in another
  /// without being its cavity. Counted if no edge is unbalanced. A shell is a sheet of triangles that touch
  /// no others.
  std::uint64_t turned_shells = 0;
  double volume = 0;  ///< signed, by the divergence theorem; positive if normals point outward
  double area = 0;
  Box box;

  /// Every edge has two triangles that run along it in opposite directions.
  bool closed() const noexcept {
    return triangles > 0 && open_edges == 0 && nonmanifold_edges == 0 && flipped_edges == 0;
  }
  /// The mesh winds round every point a whole number of times.
  bool balanced() const noexcept { return triangles > 0 && unbalanced_edges == 0; }
  /// A closed surface that meets itself nowhere and bounds a solid, normals outward.
  bool embedded() const noexcept {
    return closed() && nonmanifold_vertices == 0 && duplicate_triangles == 0 && touching_triangles == 0 &&
           turned_shells == 0;
  }
  /// What Sign::automatic becomes.
  Sign sign() const noexcept { return embedded() ? Sign::pseudonormal : Sign::winding; }
};

/// Why that sign fits, in one line: "closed, outward and embedded", or what is wrong, counted.
CDFR_API std::string sign_reason(const MeshReport& report);

/// Errors: bad_index, not_finite, out_of_range, empty_mesh (with `where` the triangle or vertex), cancelled.
/// O(n log n) but for triangles that overlap many others' boxes; thread safe.
CDFR_API Result<MeshReport> audit(MeshView mesh, const Run& run = {});

}  // namespace cdfr
