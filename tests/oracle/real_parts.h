/// Six closed parts of the shared data of different kinds, for analyses that take too long for all models.
#pragma once

#include <vector>

#include "oracle/models.h"

namespace cdfr::oracle {

/// Machined, bent, turned, organic, marching cubes, and one whose sheets touch along edges; those that are
/// there.
std::vector<Model> real_parts();

}  // namespace cdfr::oracle
