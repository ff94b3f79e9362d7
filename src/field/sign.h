/// Which side of the surface a point is on, certified.
///
/// On a closed, outward oriented, embedded mesh the sign of (p - q) . N decides, q the closest point and N
/// the normal of its face, the sum of the two normals of its edge, or the angle-weighted sum of the normals
/// at its vertex (Baerentzen, Aanaes, "Signed distance computation using the angle weighted pseudonormal",
/// 2005). A face's sign is exact already (point_triangle.h). For edges and vertices the product must exceed
/// the bound on its rounding; where it does not, or where a triangle of no area hides a normal, the signed
/// crossings of an exact ray are counted.
#pragma once

#include <vector>

#include "cdfr/core/types.h"
#include "geometry/point_triangle.h"
#include "mesh/topology.h"
#include "mesh/triangles.h"
#include "octree/search.h"

namespace cdfr {

/// By edge id and by welded vertex id. A zero vector says: undecided here, count crossings.
struct Pseudonormals {
  std::vector<Vec3> edges;     ///< sum of the unit normals, within 2u of its size and 2^-97
  std::vector<Vec3> vertices;  ///< angle-weighted mean of the unit normals, components within 2^-42
};

/// O(triangles log triangles). Precondition: `order` is the store's.
Pseudonormals pseudonormals(const Topology& topology, const TriangleStore& store);

/// 1 outside, -1 inside, 0 if the foot's distance is zero. `slot` is the closest triangle's.
int side_of(const Vec3& p, const Foot& foot, std::uint32_t slot, SearchSpace space,
            const Pseudonormals& normals) noexcept;

}  // namespace cdfr
