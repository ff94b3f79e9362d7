#include "parts/made_parts.h"
#include "parts/prism.h"

namespace cdfr {

/// papers/huang-2001, table 1: 16 triangles, box (1, 2, 2), greatest depth 0.48, concave. A prism with n
/// corners has 4n - 4 triangles, so its section is a pentagon: a block of 2 by 2 with two cusps at one end,
/// the notch between them running down to the middle, (1, 1). The counts of tables 2 and 3 are of a part that
/// fills three quarters of its box, as this does.
///
/// Depth: the thickness of 1 allows 0.5, and each half of the section a circle of radius 2 / (2 + sqrt(2)) =
/// 0.586.
Mesh one_tooth() {
  Mesh mesh;
  for (const double x : {0.0, 1.0}) {
    mesh.vertices.insert(mesh.vertices.end(), {{x, 0, 0}, {x, 2, 0}, {x, 2, 2}, {x, 1, 1}, {x, 0, 2}});
  }
  mesh.triangles = {{3, 0, 4}, {3, 1, 0}, {3, 2, 1}, {8, 9, 5}, {8, 5, 6}, {8, 6, 7}};
  add_wall(mesh, 0, 5, 5);
  return mesh;
}

}  // namespace cdfr
