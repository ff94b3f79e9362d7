/// Solids put together at random: what an analysis was not made for.
#pragma once

#include "cdfr/mesh/mesh.h"
#include "oracle/random.h"

namespace cdfr::oracle {

/// Two to six blocks and balls, turned, in a box of about 4: apart, touching by crossing, or one in another,
/// so inside is where the winding number says so, and inner faces are walls as well.
Mesh random_solid(Random& random);

}  // namespace cdfr::oracle
