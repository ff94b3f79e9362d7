/// Inside or outside: the method that the field was built with, from the cheapest certain answer on.
#pragma once

#include <optional>

#include "cdfr/core/types.h"
#include "field/field_data.h"
#include "field/query.h"

namespace cdfr {

/// 1 outside, -1 inside; 1 if unsigned or if the distance is zero. The same whether a leaf or brute force
/// found it.
int side_of(const FieldData& field, const Vec3& p, const Finding& finding) noexcept;

/// How often a balanced mesh winds round p, where the closest feature tells: on an outward shell, in front of
/// which that is 0, and 1 behind.
std::optional<int> winding_by_closest(const FieldData& field, const Vec3& p) noexcept;

}  // namespace cdfr
