#include "parts/made_parts.h"
#include "parts/prism.h"

namespace cdfr {

/// papers/huang-2001, table 1: 12 triangles, box (5, 5, 5), greatest depth 2.5: a cube with an edge of 5.
Mesh cube() {
  Mesh mesh;
  for (const double z : {0.0, 5.0}) {
    mesh.vertices.insert(mesh.vertices.end(), {{0, 0, z}, {5, 0, z}, {5, 5, z}, {0, 5, z}});
  }
  mesh.triangles = {{0, 2, 1}, {0, 3, 2}, {4, 5, 6}, {4, 6, 7}};
  add_wall(mesh, 0, 4, 4);
  return mesh;
}

}  // namespace cdfr
