/// The ways to build one part's complete distance field that the tables set side by side.
#pragma once

#include <array>
#include <string>

#include "cdfr/core/result.h"
#include "cdfr/core/run.h"
#include "cdfr/field/field.h"
#include "cdfr/reference/uniform.h"
#include "tables/voxel_mesh.h"

namespace cdfr::bench {

enum class Way {
  uniform,      ///< the papers' own: reference room, voxels as points, surface voxels that do not inherit
  octree_band,  ///< cells split while they list more than one triangle, by the papers' range
  octree_own,   ///< the same, by corner dominance
  octree,       ///< cells split while they list more than `entry_triangles`, if it pays
  standard,     ///< BuildOptions as they are: cells as large as they like
};
inline constexpr std::array all_ways{Way::uniform, Way::octree_band, Way::octree_own, Way::octree,
                                     Way::standard};

/// An octree's entries are groups of so many triangles: a shorter list is no less to look through.
inline constexpr int entry_triangles = 8;

std::string name_of(Way way);

/// How all of them are run.
Run one_thread();

/// On one thread. Of an octree's all but `standard` the deepest cells are the mesh's voxels, and only cells
/// that the surface or the inside comes into have lists, as with the papers.
Result<UniformField> build_uniform(const VoxelMesh& mesh);
Result<Field> build_octree(Way way, const VoxelMesh& mesh);

/// What became of it. Means are of the triangles a voxel lists: a leaf counts for each voxel that it holds.
struct ListCounts {
  double inside = 0, surface = 0, outside = 0;  ///< voxels, or leaves
  double inside_mean = 0, surface_mean = 0;
  std::string grid;         ///< voxels along each axis of the uniform field
  double stated_bytes = 0;  ///< 4 n + 5 a voxel or leaf with a list of n, 1 another
};

ListCounts lists_of(const UniformField& field);
/// A dropped leaf counts as outside.
ListCounts lists_of(const Field& field);

/// Means of what no complete list of a voxel can leave out, over surface leaves and inside ones.
struct LeastLists {
  double inside_mean = 0, surface_mean = 0;
};
LeastLists least_lists(const Field& field);

}  // namespace cdfr::bench
