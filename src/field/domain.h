/// Cells that a field's domain leaves out.
#pragma once

#include "field/field_data.h"
#include "octree/block_builder.h"

namespace cdfr {

/// By the field's options. The field has everything but the octree, its lattice is laid, and it must outlive
/// this.
LeftOut cells_left_out(const FieldData& field);

/// Does the leaf have the whole BVH for a list?
bool is_left_out(const FieldData& field, const Block& block, const LeafRecord& leaf) noexcept;

}  // namespace cdfr
