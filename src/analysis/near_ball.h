/// What a ball touches.
#pragma once

#include <cstdint>
#include <vector>

#include "cdfr/core/types.h"
#include "field/field_data.h"

namespace cdfr {

/// Numbers in the input of the triangles no farther from the point than that, ascending. O(log n) and what is
/// near.
std::vector<std::uint32_t> triangles_within(const FieldData& field, const Vec3& centre, double radius);

}  // namespace cdfr
