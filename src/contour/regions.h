/// The cubes that a contour may pass through: leaves of the octree, and cubes of the brick's size beyond it.
#pragma once

#include <cstddef>
#include <vector>

#include "contour/descent.h"
#include "contour/level.h"
#include "field/field_data.h"

namespace cdfr {

struct Regions {
  std::vector<Cube> leaves;  ///< in Morton order
  std::vector<Cube> beyond;  ///< in Morton order of a larger cube
};

/// Leaves whose list starts farther away than the contour are left out, and cubes that the slope of 1 rules
/// out. O(leaves + cubes beyond the domain that the contour meets).
Regions regions_of(const FieldData& field, const Level& level);

}  // namespace cdfr
