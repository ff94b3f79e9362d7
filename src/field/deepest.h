/// The deepest point inside a part: the centre of the largest ball that fits in.
#pragma once

#include <span>

#include "cdfr/core/result.h"
#include "cdfr/field/field.h"
#include "core/progress.h"
#include "field/field_data.h"
#include "geometry/cube.h"

namespace cdfr {

/// Branch and bound over the leaves (Land and Doig 1960). A cube of edge s and centre c has no point deeper
/// than
///  - the depth of c and sqrt(3)/2 s, since the distance has slope 1, or
///  - distance_above's bound, which is exact between parallel walls, where the slope alone would leave all
///    cubes of a plate's middle plane to the end.
/// The cube with about the largest bound is halved next, until none exceeds the deepest centre by more than
/// `error`. Where the mesh is open the sign jumps off the surface, so there bounds are of the unsigned
/// distance.
///
/// Precondition: the field is signed. Runs in the caller's task arena.
Result<Deepest> deepest_point(const FieldData& field, double error, Progress& progress);

/// The deepest point of these cubes.
Result<Deepest> deepest_among(const FieldData& field, std::span<const Cube> cubes, double error,
                              Progress& progress);

}  // namespace cdfr
