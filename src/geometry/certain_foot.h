/// The kernel where the foot's place is known: the three coordinates side by side in a vector.
#pragma once

#include "geometry/point_triangle.h"

namespace cdfr {

/// Sets `foot` to the bits that point_triangle.cpp gives for that place. False, and nothing of use in `foot`,
/// where rounding leaves something open, and where the processor has no vectors of four doubles with fused
/// multiply-add. Precondition: estimate_place found that place.
bool measure_certain(TrianglePlace place, const Vec3& p, const TriangleShape& triangle, Foot& foot) noexcept;

}  // namespace cdfr
