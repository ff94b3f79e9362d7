#include "parts/made_parts.h"

namespace cdfr {

/// papers/huang-2001, table 1: 4 triangles, box (1, 1, 1), greatest depth 0.2, "symmetric". The corner of a
/// cube: its inscribed ball has the radius 3 * volume / area = (1/2) / (3/2 + sqrt(3)/2) = 1 / (3 + sqrt(3))
/// = 0.2113. The regular tetrahedron in the same box has 0.2887.
Mesh tetrahedron() {
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  return mesh;
}

}  // namespace cdfr
