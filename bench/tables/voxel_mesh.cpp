#include "tables/voxel_mesh.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "cdfr/field/field.h"
#include "models.h"

namespace cdfr::bench {
namespace {

/// The edge of level 0 cells, a power of two, as a field over a mesh of that box has it.
double cell_edge(const Box& box) {
  Mesh diagonal;
  diagonal.vertices = {box.lo, box.hi};
  diagonal.triangles = {{0, 1, 1}};
  BuildOptions options;
  options.max_level = 0;
  options.margin = 0;
  const Leaf leaf = Field::build(diagonal.view(), options).value().leaf(0);
  return leaf.box.hi.x - leaf.box.lo.x;
}

}  // namespace

VoxelMesh in_voxels(const Mesh& mesh, int resolution) {
  const Box box = box_of(mesh);
  const double longest = std::max({box.hi.x - box.lo.x, box.hi.y - box.lo.y, box.hi.z - box.lo.z});
  VoxelMesh made;
  made.mesh = mesh;
  made.along = resolution - 2 * empty_voxels;
  made.voxel = longest / made.along;
  const auto counted = [&](double x, double lo) { return (x - lo) / made.voxel + 0.5; };
  for (Vec3& v : made.mesh.vertices)
    v = {counted(v.x, box.lo.x), counted(v.y, box.lo.y), counted(v.z, box.lo.z)};
  assert(resolution >= 32);
  made.level = std::ilogb(cell_edge(box_of(made.mesh)));
  return made;
}

}  // namespace cdfr::bench
