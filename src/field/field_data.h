/// What a field is made of.
#pragma once

#include <cstdint>
#include <vector>

#include "cdfr/field/field.h"
#include "field/sign.h"
#include "mesh/bvh.h"
#include "mesh/triangles.h"
#include "octree/blocks.h"
#include "octree/search.h"

namespace cdfr {

struct FieldData {
  TriangleStore triangles;
  Bvh bvh;
  Pseudonormals pseudonormals;  ///< empty if unsigned
  Octree tree;                  ///< without blocks in a brute force's data
  BuildOptions options;
  Sign sign = Sign::none;  ///< never automatic
  /// Side of every point outside the mesh's box: 1, -1 for a mesh turned inside out, 0 where only
  /// pseudonormals tell (a mesh that is not closed).
  int far_side = 0;
  std::uint64_t vertices = 0;             ///< distinct
  std::vector<std::uint64_t> first_leaf;  ///< leaves before each block; derived

  SearchSpace space() const noexcept { return {triangles, bvh}; }
  const Box& bounds() const noexcept { return bvh.nodes[0].box; }
};

}  // namespace cdfr
