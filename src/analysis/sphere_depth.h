/// The deepest point of a sphere.
#pragma once

#include "cdfr/core/types.h"
#include "core/progress.h"
#include "field/field_data.h"

namespace cdfr {

/// The greatest depth on that sphere, found to within the error; 0 if all of it is outside. Branch and bound
/// over cubes that the sphere passes: no point of one is deeper than its centre by more than half its
/// diagonal. O((radius / error)^2) where all of it is about as deep, O(radius / error) where a wall crosses
/// it.
double depth_on_sphere(const FieldData& field, const Vec3& centre, double radius, double error,
                       Progress& progress);

}  // namespace cdfr
