/// Which leaves are on one side of the surface, all of them.
#pragma once

#include "core/progress.h"
#include "field/field_data.h"

namespace cdfr {

/// Gives each leaf of the block that no triangle comes into the side that all of it is on, where that is
/// certain. Precondition: the field's octree is that block alone, and indexed. Polls the progress; incomplete
/// if that is cancelled.
void set_sides(const FieldData& field, Block& block, Progress& progress);

/// Is the side of a ball without triangles ever certain?
bool sides_are_certain(const FieldData& field) noexcept;
/// Of all of the ball, in which there is no triangle. Precondition: sides are certain.
Side side_of_free_ball(const FieldData& field, const Vec3& centre, double radius) noexcept;

}  // namespace cdfr
