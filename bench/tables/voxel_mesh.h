/// A mesh counted in voxels, so that the reference's voxels and the octree's cells are the same cubes.
#pragma once

#include "cdfr/mesh/mesh.h"

namespace cdfr::bench {

/// The papers' resolutions count four empty voxels on each side of the longest extent.
inline constexpr int empty_voxels = 4;

struct VoxelMesh {
  Mesh mesh;         ///< its voxels have an edge of 1, and corners of integers
  int along = 0;     ///< voxels along the longest side of its box
  double voxel = 0;  ///< edge of one in the unit of the mesh that it was made of
  /// Of an octree over `mesh` whose deepest cells are the voxels.
  int level = 0;
};

/// For a grid of that resolution, 4 empty voxels on each side counted, whose voxels have the lattice's points
/// in their middle (UniformVoxels::points). Precondition: the resolution is 32 or more, so that level 0 cells
/// are larger than voxels; the mesh is not empty.
VoxelMesh in_voxels(const Mesh& mesh, int resolution);

}  // namespace cdfr::bench
