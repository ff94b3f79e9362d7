/// Brings together vertices that are almost at one place, on request and with a count of what it did.
#pragma once

#include <cstdint>
#include <vector>

#include "cdfr/core/api.h"
#include "cdfr/core/result.h"
#include "cdfr/core/run.h"
#include "cdfr/mesh/mesh.h"

namespace cdfr {

struct WeldReport {
  std::uint64_t merged_vertices = 0;      ///< distinct positions that moved onto another one
  std::uint64_t collapsed_triangles = 0;  ///< dropped: two of their corners are one vertex now
  double largest_move = 0;                ///< of a vertex; at most the tolerance, to rounding
};

struct Welded {
  /// Triangles in their old order, vertices each at a place of its own and by first use; patches as they
  /// were.
  Mesh mesh;
  std::vector<std::uint32_t> numbers;  ///< by triangle of `mesh`: its number before
  WeldReport report;
};

/// Positions are taken in an order that depends on them alone: by cells of a grid, then by x, y, z. One that
/// has no kept position within `tolerance` (compared exactly) is kept; each of the others moves to the
/// nearest kept one by rounded distance, the earliest of equally near ones. So nothing moves farther than the
/// tolerance, in a chain of near points neither; kept positions are farther apart than it; and the positions
/// that result do not depend on the order of vertices or triangles. Tolerance 0 makes one vertex of equal
/// coordinates (-0 equals 0).
///
/// Triangles of which two corners are one vertex are dropped and counted, also if they were one before.
/// Duplicates and triangles whose corners come to lie on a line are kept: the audit counts them. Vertices
/// that no triangle uses are left out and attract nothing.
///
/// Errors: bad_option if the tolerance is negative, not finite or more than a hundredth of the longest side
/// of the mesh's box, or if there are patches but not one a triangle; audit's; empty_mesh if no triangle is
/// left; cancelled. O(n log n) whatever the vertices, for kept positions are sparse; thread safe.
CDFR_API Result<Welded> weld(const Mesh& mesh, double tolerance, const Run& run = {});

}  // namespace cdfr
