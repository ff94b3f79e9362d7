/// A model made ready for measuring queries: its field, the points to ask at, and a contour worth extracting.
#pragma once

#include <string>
#include <vector>

#include "cdfr/core/result.h"
#include "cdfr/core/types.h"
#include "cdfr/field/field.h"
#include "cdfr/mesh/mesh.h"

namespace cdfr::bench {

struct Subject {
  Mesh mesh;
  Field field;
  double longest_side = 0;
  std::vector<Vec3> anywhere{};      ///< evenly spread in the box of the mesh, a tenth larger
  std::vector<Vec3> near_surface{};  ///< within 1/1000 of the longest side of a closest point
  double contour_distance = 0;  ///< a quarter of the deepest of 1000 points; outside if there is no inside
};

/// The same points on every machine.
Result<Subject> make_subject(Mesh mesh);

}  // namespace cdfr::bench
