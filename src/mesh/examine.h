/// A mesh taken apart: what its audit says, and all that was made to find out, which a field needs too.
#pragma once

#include <cstdint>

#include "cdfr/mesh/audit.h"
#include "core/progress.h"
#include "core/scratch.h"
#include "mesh/bvh.h"
#include "mesh/topology.h"
#include "mesh/triangles.h"

namespace cdfr {

struct Examined {
  explicit Examined(const Scratch* scratch = nullptr)
      : topology(scratch), plain_edges(scratch), plain_vertices(scratch) {}

  MeshReport report;
  Topology topology;
  Bvh bvh;
  TriangleStore triangles;  ///< with their sides, if the mesh is balanced
  /// By edge and vertex id: 1 if the triangles there are one sheet of one shell, which no others touch.
  Large<std::uint8_t> plain_edges, plain_vertices;

  SearchSpace space() const noexcept { return {triangles, bvh}; }
};

/// Errors: audit's. Runs in the caller's task arena. O(n log n) but for triangles that overlap many others'
/// boxes. All that grows with the mesh lies in the scratch, which must outlive the answer; of anonymous
/// memory it takes less than 32 MB then, for no more than so many arrays are there at a time that are smaller
/// than Scratch::large.
Result<Examined> examine(MeshView mesh, Progress& progress, const Scratch* scratch = nullptr);

}  // namespace cdfr
