/// From a mesh to what a field is made of.
#pragma once

#include <optional>

#include "cdfr/core/result.h"
#include "core/progress.h"
#include "core/scratch.h"
#include "field/field_data.h"

namespace cdfr {

/// Everything but the octree: enough for brute force. Resolves Sign::automatic. What is large lies in the
/// scratch, which must outlive it. Runs in the caller's task arena.
Result<FieldData> prepare_field(MeshView mesh, const BuildOptions& options, Progress& progress,
                                const Scratch* scratch = nullptr);
/// What is out of its range.
std::optional<Error> refused(const BuildOptions& options);

Result<FieldData> build_field(MeshView mesh, const BuildOptions& options, const Run& run);

/// far_side, from the report.
void derive_far_side(FieldData& field) noexcept;
/// The lattice, the deepest level if that is automatic, and the groups of the scan. Runs in the caller's task
/// arena.
void lay_lattice(FieldData& field, const Scratch* scratch = nullptr);

}  // namespace cdfr
