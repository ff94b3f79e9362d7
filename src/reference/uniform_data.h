/// What a uniform field is made of, and the steps that make it, in the order of the paper.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "cdfr/core/result.h"
#include "cdfr/reference/uniform.h"
#include "core/progress.h"
#include "mesh/topology.h"
#include "mesh/triangles.h"
#include "reference/grid.h"

namespace cdfr {

/// The mesh. Slots of the store are triangle numbers.
struct ReferenceSurface {
  TriangleStore triangles;
  Topology topology;
  std::vector<std::uint64_t> first_around;  ///< by welded vertex, and an end
  std::vector<std::uint32_t> around;        ///< triangles at each vertex, ascending

  std::span<const std::uint32_t> around_vertex(std::uint32_t vertex) const noexcept {
    return std::span<const std::uint32_t>(around).subspan(first_around[vertex],
                                                          first_around[vertex + 1] - first_around[vertex]);
  }
};

using CellLists = std::vector<std::vector<CddTuple>>;

struct UniformData {
  UniformOptions options;
  ReferenceSurface surface;
  VoxelGrid grid;
  std::vector<Side> sides;
  CellLists lists;  ///< a voxel that was dropped has an empty one
  std::uint64_t rounds = 0, measured = 0;
};

ReferenceSurface reference_surface(MeshView mesh);

/// The tuple of a triangle at a voxel's centre, by the library's kernel.
CddTuple cdd_tuple(const ReferenceSurface& surface, const Vec3& centre, std::uint32_t triangle) noexcept;

/// Error: out_of_range beyond most_uniform_tuples.
Result<void> expect_few_enough(std::uint64_t tuples);

/// Section 3.3: lists with each voxel the triangles that touch it, or are as near to its point as
/// UniformVoxels has it, and calls it surface; all others are inside.
Result<void> voxelise(UniformData& data, Progress& progress);

/// Surface voxels whose point lies outside, by the base triangle's side, become outside ones.
void drop_outside_points(UniformData& data);

/// Section 3.4: what an untouched voxel of the outermost layer reaches without passing a surface voxel is
/// outside.
void flood_outside(UniformData& data);

/// Section 3.4: lists spread to the 26 neighbours. Error: out_of_range. Runs in the caller's task arena.
Result<void> propagate(UniformData& data, Progress& progress);

}  // namespace cdfr
