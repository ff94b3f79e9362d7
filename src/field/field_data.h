/// What a field is made of.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "cdfr/field/field.h"
#include "core/guarded_map.h"
#include "field/leaf_winding.h"
#include "field/sign.h"
#include "field/winding.h"
#include "geometry/scan_group.h"
#include "mesh/bvh.h"
#include "mesh/triangles.h"
#include "octree/leaf_index.h"
#include "octree/scan.h"

namespace cdfr {

struct FieldData {
  TriangleStore triangles;
  Bvh bvh;
  Pseudonormals pseudonormals;  ///< empty if unsigned
  Octree tree;                  ///< without blocks in a brute force's data
  BuildOptions options;
  Sign sign = Sign::none;  ///< never automatic
  MeshReport report;
  WindingTree winding;  ///< for a mesh that is not balanced, if winding decides
  /// Side of every point outside the mesh's box: 1, -1 for a closed mesh turned inside out whose
  /// pseudonormals decide, 0 where it depends on the point.
  int far_side = 0;
  std::shared_ptr<const GuardedMap> map;  ///< that the arrays lie in, if they are a file's
  LeafIndex index;
  LeafWindings leaf_windings;  ///< where winding decides
  Array<ScanGroup> scan_groups;

  SearchSpace space() const noexcept { return {triangles, bvh}; }
  ScanSpace scan_space() const noexcept { return {triangles, scan_groups.data(), bvh, tree.lattice}; }
  /// Something read from the file was bad: no answer counts.
  bool failed() const noexcept { return map != nullptr && map->failed(); }
  Result<void> status() const { return map == nullptr ? Result<void>() : map->status(); }
  const Box& bounds() const noexcept { return bvh.nodes[0].box; }
};

}  // namespace cdfr
