/// CGAL's word on a surface, exact on its coordinates.
#pragma once

#include "cdfr/mesh/mesh.h"

namespace cdfr::test {

struct SurfaceVerdict {
  bool closed = true;
  bool meets_itself = false;
  bool bounds_volume = true;
};

/// Where CGAL was not found the verdict is as above for every mesh.
SurfaceVerdict judge_surface(const Mesh& mesh);
bool has_surface_oracle();

}  // namespace cdfr::test
