/// A field with its octree cut at a level.
#pragma once

#include "field/field_data.h"

namespace cdfr {

/// Shares all but the octree. Of leaves made of several no winding is known: where it decides and the leaf
/// does not tell the side, queries count along a ray. Precondition: level is 0 to 18.
FieldData cut_field(const FieldData& field, int level);

}  // namespace cdfr
