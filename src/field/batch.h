/// Queries of many points in stages: each step is taken for a bundle of points before the next one, so that
/// their cache misses overlap instead of following each other.
#pragma once

#include <cstddef>
#include <span>

#include "cdfr/core/points.h"
#include "cdfr/field/field.h"
#include "field/field_data.h"

namespace cdfr {

/// Points that are under way together.
inline constexpr std::size_t bundle_size = 32;

/// The answers of signed_distance and closest_point (query.h) to the points first .. first + out.size() - 1.
/// At most bundle_size of them.
void answer_bundle(const FieldData& field, Points x, std::size_t first, std::span<double> out) noexcept;
void answer_bundle(const FieldData& field, Points x, std::size_t first, std::span<Closest> out) noexcept;

}  // namespace cdfr
