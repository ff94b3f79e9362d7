/// The brick in equal parts, each a task.
#pragma once

#include <vector>

#include "octree/lattice.h"

namespace cdfr {

/// All cells of that level in the brick, by z, y, x. Precondition: level >= 0.
std::vector<Cell> task_cells(const Lattice& lattice, int level);

}  // namespace cdfr
