/// The distances of a whole grid: neighbouring samples share a leaf's list, and what its triangles have in
/// common.
#pragma once

#include <span>

#include "cdfr/core/result.h"
#include "cdfr/core/run.h"
#include "cdfr/field/grid.h"
#include "field/field_data.h"

namespace cdfr {

/// The bits of signed_distance at each sample. Errors: cancelled. Precondition: out.size() == grid.count().
Result<void> grid_distances(const FieldData& field, const Grid& grid, std::span<double> out, const Run& run);

}  // namespace cdfr
