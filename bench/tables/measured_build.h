/// What a field of one of the ways holds, and what it took.
#pragma once

#include <string>

#include "tables/ways.h"

namespace cdfr::bench {

struct MeasuredBuild {
  ListCounts lists;
  double seconds = 0;   ///< of processor time
  double bytes = 0;     ///< that malloc holds more, mesh included
  std::string refused;  ///< why there is nothing of all this; empty if there is
};

MeasuredBuild measured_build(Way way, const VoxelMesh& mesh);

}  // namespace cdfr::bench
