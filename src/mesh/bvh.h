/// A binary tree of boxes over the groups of triangles.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "cdfr/core/types.h"
#include "core/array.h"
#include "core/scratch.h"
#include "mesh/topology.h"
#include "mesh/triangles.h"

namespace cdfr {

/// Nodes are in preorder: the left child of node i is i + 1, the right one i + 2 * groups(i + 1).
/// One cache line.
struct alignas(64) BvhNode {
  Box box;  ///< exact: of the vertices
  std::uint32_t first_group = 0;
  std::uint32_t end_group = 0;
  std::uint64_t zero = 0;  ///< to 64 bytes, written to files

  std::uint32_t groups() const noexcept { return end_group - first_group; }
  bool is_group() const noexcept { return groups() == 1; }
};
static_assert(sizeof(BvhNode) == 64);

/// No path from the root is longer.
inline constexpr int bvh_depth_limit = 72;

struct Bvh {
  Array<BvhNode> nodes;

  std::uint32_t left(std::uint32_t node) const noexcept { return node + 1; }
  std::uint32_t right(std::uint32_t node) const noexcept { return node + 2 * nodes[node + 1].groups(); }
};

/// Order of triangles and the tree over it. Splits by the surface area heuristic over 32 bins of each axis
/// (Wald, "On fast construction of SAH-based bounding volume hierarchies", 2007), at multiples of eight so
/// that all groups but the last are full. Ties go by triangle number; the same for any number of threads. O(n
/// log n). Precondition: the mesh is not empty. Runs in the caller's task arena.
struct BvhAndOrder {
  Bvh bvh;
  Large<std::uint32_t> order;  ///< triangle numbers by slot
};
BvhAndOrder build_bvh(MeshView mesh, const Scratch* scratch = nullptr);

/// Depth first from `root`, left before right: enter(node) says whether to look into a node, group(node) is
/// called for each group that was entered and ends the walk by returning false. True if nothing did.
template <class Enter, class Group>
bool walk(const Bvh& bvh, std::uint32_t root, Enter enter, Group group) {
  std::array<std::uint32_t, bvh_depth_limit> stack;
  std::size_t size = 0;
  stack[size++] = root;
  while (size > 0) {
    const std::uint32_t index = stack[--size];
    if (!enter(index)) continue;
    if (!bvh.nodes[index].is_group()) {
      stack[size++] = bvh.right(index);
      stack[size++] = bvh.left(index);
    } else if (!group(index)) {
      return false;
    }
  }
  return true;
}

/// The mesh and the tree over it, borrowed.
struct SearchSpace {
  const TriangleStore& triangles;
  const Bvh& bvh;
};

}  // namespace cdfr
