/// What a contour takes as a mesh, unless it takes too long.
#pragma once

#include <string>

#include "cdfr/field/field.h"

namespace cdfr::bench {

struct MeshTime {
  double us_triangle = 0;  ///< microseconds of processor time for each triangle that comes out
  std::string left_out;    ///< why there is no such figure, else empty
};

/// On one thread; given up after `limit` seconds of processor time.
MeshTime mesh_time(const Field& field, double distance, double tolerance, double limit);

}  // namespace cdfr::bench
