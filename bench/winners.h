/// What no complete list can leave out.
#pragma once

#include <cstddef>

#include "cdfr/core/types.h"
#include "cdfr/field/field.h"

namespace cdfr::bench {

/// Triangles that are the closest one of some sample strictly inside the box. A finer lattice finds more, so
/// this is a lower bound of the least complete list.
std::size_t winners(const Field& field, const Box& box);

}  // namespace cdfr::bench
