/// Which side of the surface a point is on, certified, where the surface around the closest point tells.
///
/// On a closed, outward oriented, embedded mesh the sign of (p - q) . N decides, q the closest point and N
/// the normal of its face, the sum of the two normals of its edge, or the angle-weighted sum of the normals
/// at its vertex (Baerentzen, Aanaes, "Signed distance computation using the angle weighted pseudonormal",
/// 2005). A face's sign is exact already (point_triangle.h). For edges and vertices the product must exceed
/// the bound on its rounding; where it does not, or where a triangle of no area hides a normal, it is left
/// open. On a balanced mesh that is not embedded the same holds around each plain edge and vertex
/// (mesh/shells.h).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "cdfr/core/types.h"
#include "core/array.h"
#include "core/scratch.h"
#include "geometry/point_triangle.h"
#include "mesh/triangles.h"

namespace cdfr {

/// By edge id and by welded vertex id. A zero vector says: undecided here, count crossings.
struct Pseudonormals {
  Array<Vec3> edges;     ///< sum of the unit normals, within 2u of its size and 2^-97
  Array<Vec3> vertices;  ///< angle-weighted mean of the unit normals, components within 2^-42

  /// Precondition: the place is an edge or a vertex.
  const Vec3& at(TrianglePlace place, const TriangleRecord& record) const noexcept {
    return place < 4 ? edges[record.edges[place - 1]] : vertices[record.vertices[place - 4]];
  }
};

/// `plain_edges` and `plain_vertices` leave out what is not plain (Examined); empty ones leave out nothing.
/// O(triangles). Runs in the caller's task arena.
Pseudonormals pseudonormals(const TriangleStore& store, std::size_t edges, std::size_t vertices,
                            std::span<const std::uint8_t> plain_edges,
                            std::span<const std::uint8_t> plain_vertices, const Scratch* scratch = nullptr);

/// 1 on the side that the normal at the foot points to, -1 on the other one, 0 undecided. `reach` is at least
/// the distance from the point to the triangle's vertices. Precondition: the foot is on an edge or vertex,
/// its distance not zero, and `normal` is the pseudonormal there.
int side_of_normal(const Foot& foot, const Vec3& normal, double reach) noexcept;

}  // namespace cdfr
