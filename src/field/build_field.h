/// From a mesh to what a field is made of.
#pragma once

#include "cdfr/core/result.h"
#include "field/field_data.h"

namespace cdfr {

/// Everything but the octree: enough for brute force. Resolves Sign::automatic. Runs in the caller's task
/// arena.
Result<FieldData> prepare_field(MeshView mesh, const BuildOptions& options);

Result<FieldData> build_field(MeshView mesh, const BuildOptions& options, const Run& run);

/// Sets what follows from the rest: first_leaf.
void index_leaves(FieldData& field);

}  // namespace cdfr
