#include "parts/made_parts.h"
#include "parts/prism.h"

namespace cdfr {

/// papers/huang-2001-report, figure 7: a two-ended tooth, of which no number is told. It is the one-tooth's
/// block, in the same box (1, 2, 2), with two cusps at either end and notches of half the depth between them:
/// a prism on a hexagon, so 4 * 6 - 4 = 20 triangles.
///
/// Depth: the thickness of 1 allows 0.5, and each half of the section a circle of radius 2 / (1 + sqrt(5)) =
/// 0.618.
Mesh two_ended_tooth() {
  Mesh mesh;
  for (const double x : {0.0, 1.0}) {
    mesh.vertices.insert(mesh.vertices.end(),
                         {{x, 0, 0}, {x, 1, 0.5}, {x, 2, 0}, {x, 2, 2}, {x, 1, 1.5}, {x, 0, 2}});
  }
  mesh.triangles = {{0, 4, 1},  {0, 5, 4},   {1, 3, 2}, {1, 4, 3},
                    {6, 7, 10}, {6, 10, 11}, {7, 8, 9}, {7, 9, 10}};
  add_wall(mesh, 0, 6, 6);
  return mesh;
}

}  // namespace cdfr
