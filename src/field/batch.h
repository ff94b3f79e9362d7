/// Queries of many points in stages: each step is taken for a bundle of points before the next one, so that
/// their cache misses overlap instead of following each other.
#pragma once

#include <cstddef>
#include <span>

#include "cdfr/core/points.h"
#include "cdfr/field/field.h"
#include "core/progress.h"
#include "field/field_data.h"

namespace cdfr {

/// The answers of signed_distance and closest_point (query.h) to the points first .. first + out.size() - 1.
/// False if cancelled.
bool answer(const FieldData& field, Points x, std::size_t first, std::span<double> out, Progress& progress);
bool answer(const FieldData& field, Points x, std::size_t first, std::span<Closest> out, Progress& progress);

}  // namespace cdfr
