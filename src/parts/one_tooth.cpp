#include "parts/made_parts.h"
#include "parts/prism.h"

namespace cdfr {

/// papers/huang-2001, table 1: 16 triangles, box (1, 2, 2), greatest depth 0.48, concave. A prism with n
/// corners has 4n - 4 triangles, so its section is a pentagon: a block of 2 by 3/4 with one tooth at one end,
/// the tooth's back running from (0, 2) to the inner corner (7/8, 3/4).
///
/// Depth: the back's line, y = 2 - (10/7) x, makes a right triangle with the legs 7/5 and 2, and the
/// section's largest inscribed circle is that triangle's: its radius is half of (7/5 + 2 - sqrt(149)/5),
/// 0.47934, and it touches the back at x = 0.872, just before the back ends at x = 7/8. The thickness of 1
/// would allow 0.5.
Mesh one_tooth() {
  Mesh mesh;
  for (const double x : {0.0, 1.0}) {
    mesh.vertices.insert(mesh.vertices.end(),
                         {{x, 0, 0}, {x, 2, 0}, {x, 2, 0.75}, {x, 0.875, 0.75}, {x, 0, 2}});
  }
  mesh.triangles = {{3, 0, 4}, {3, 1, 0}, {3, 2, 1}, {8, 9, 5}, {8, 5, 6}, {8, 6, 7}};
  add_wall(mesh, 0, 5, 5);
  return mesh;
}

}  // namespace cdfr
