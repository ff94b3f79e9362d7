/// The deepest point inside a part: the centre of the largest ball that fits in.
#pragma once

#include "cdfr/core/result.h"
#include "cdfr/field/field.h"
#include "core/progress.h"
#include "field/field_data.h"

namespace cdfr {

/// By branch and bound over the leaves (deepest_search.h).
/// Precondition: the field is signed. Runs in the caller's task arena.
Result<Deepest> deepest_point(const FieldData& field, double error, Progress& progress);

}  // namespace cdfr
