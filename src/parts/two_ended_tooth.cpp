#include "parts/made_parts.h"
#include "parts/prism.h"

namespace cdfr {

/// papers/huang-2001-report, figure 7: a two-ended tooth, of which no number is told. It is the one-tooth
/// with a second tooth at the other end, in the same box (1, 2, 2): a prism on a hexagon, so 4 * 6 - 4 = 20
/// triangles.
///
/// Depth: the one-tooth's, twice. Its largest circle reaches from the end of the block to 0.95868, short of
/// the middle at 1, so the second tooth and its own circle leave it alone: 0.47934.
Mesh two_ended_tooth() {
  Mesh mesh;
  for (const double x : {0.0, 1.0}) {
    mesh.vertices.insert(mesh.vertices.end(),
                         {{x, 0, 0}, {x, 2, 0}, {x, 2, 2}, {x, 1.125, 0.75}, {x, 0.875, 0.75}, {x, 0, 2}});
  }
  mesh.triangles = {{4, 0, 5},   {4, 1, 0},  {4, 3, 1},  {3, 2, 1},
                    {10, 11, 6}, {10, 6, 7}, {10, 7, 9}, {9, 7, 8}};
  add_wall(mesh, 0, 6, 6);
  return mesh;
}

}  // namespace cdfr
