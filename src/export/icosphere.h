/// A round ball of triangles.
#pragma once

#include <cstdint>
#include <vector>

#include "export/glb_format.h"

namespace cdfr {

struct Icosphere {
  std::vector<glb::Float3> vertices;   ///< on the unit sphere about the origin: normals too
  std::vector<std::uint32_t> corners;  ///< three a triangle, seen from outside against the clock
};

/// An icosahedron whose triangles were cut in four three times: 642 vertices, 1280 triangles, within 1/100 of
/// the sphere.
Icosphere icosphere();

}  // namespace cdfr
