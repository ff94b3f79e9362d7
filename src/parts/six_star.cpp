#include <array>
#include <cmath>
#include <cstdint>

#include "parts/made_parts.h"
#include "parts/prism.h"

namespace cdfr {

/// papers/huang-2001, table 1: 48 triangles, box (1, 3, 3.46), greatest depth 0.49, concave. A hexagram whose
/// points lie at the distance sqrt(3) from its axis measures 3 by 2 sqrt(3), and its inner corners lie at 1.
/// Its 12 corners give 24 triangles of wall, so each face has 12: a fan around a middle vertex.
///
/// A flat face would make the greatest depth 0.5. The fan allows a dish, and with one of 1/64 the depth is
/// what the table says: each of its planes falls by 1/64 from the outline to the axis, over s = sqrt(3)/2, so
/// c = s / sqrt(s^2 + 1/64^2) is its cosine. At half height, at the distance d from an inner corner towards
/// the axis, the faces are c (1/2 - d/64) away and the corner's edge d: equal for d = (c/2) / (1 + c/64) =
/// 0.49223. Anywhere else a ball is smaller, at the points' flanks 0.49106.
Mesh six_star() {
  const double s = std::sqrt(3.0) / 2;
  const std::array<Vec3, 12> ring{{{0, 0, 2 * s},
                                   {0, -0.5, s},
                                   {0, -1.5, s},
                                   {0, -1, 0},
                                   {0, -1.5, -s},
                                   {0, -0.5, -s},
                                   {0, 0, -2 * s},
                                   {0, 0.5, -s},
                                   {0, 1.5, -s},
                                   {0, 1, 0},
                                   {0, 1.5, s},
                                   {0, 0.5, s}}};
  constexpr std::uint32_t count = 12;
  constexpr double dish = 1.0 / 64;
  Mesh mesh;
  for (const double x : {0.0, 1.0}) {
    for (const Vec3& corner : ring) mesh.vertices.push_back({x, corner.y, corner.z});
  }
  mesh.vertices.push_back({dish, 0, 0});
  mesh.vertices.push_back({1 - dish, 0, 0});
  add_wall(mesh, 0, count, count);
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t next = (i + 1) % count;
    mesh.triangles.push_back({2 * count, next, i});
    mesh.triangles.push_back({2 * count + 1, count + i, count + next});
  }
  return mesh;
}

}  // namespace cdfr
