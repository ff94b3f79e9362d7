/// What a field would be, before it is built.
#pragma once

#include <cstdint>

#include "cdfr/core/api.h"
#include "cdfr/core/result.h"
#include "cdfr/core/run.h"
#include "cdfr/mesh/mesh.h"
#include "cdfr/octree/options.h"

namespace cdfr {

/// Estimates, but for the triangles.
struct FieldPlan {
  std::uint64_t triangles = 0;
  std::uint64_t leaves = 0, entries = 0;  ///< as Stats counts them, those that a domain leaves out included
  std::uint64_t bytes = 0;                ///< of the field in memory; its file is as large
  std::uint64_t peak_bytes = 0;           ///< of anonymous memory while Field::build makes it
  double seconds = 0;                     ///< of Field::build on as many threads
};

/// Makes everything but the octree, and a sample of the octree's blocks: a third to a half of a build's time.
/// Errors: Field::build's.
CDFR_API Result<FieldPlan> plan_field(MeshView mesh, const BuildOptions& options = {}, const Run& run = {});

}  // namespace cdfr
