/// From a mesh to what a field is made of.
#pragma once

#include "cdfr/core/result.h"
#include "core/progress.h"
#include "field/field_data.h"

namespace cdfr {

/// Everything but the octree: enough for brute force. Resolves Sign::automatic. Runs in the caller's task
/// arena.
Result<FieldData> prepare_field(MeshView mesh, const BuildOptions& options, Progress& progress);

Result<FieldData> build_field(MeshView mesh, const BuildOptions& options, const Run& run);

/// What follows from the rest and is not stored: far_side and winding; first_leaf and index; scan_groups. So
/// does leaf_windings (leaf_winding.h), from all of these and the leaves' sides.
void derive_sides(FieldData& field);
void index_leaves(FieldData& field);
void derive_scan_groups(FieldData& field);

}  // namespace cdfr
