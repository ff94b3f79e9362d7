/// What is measured on one model: the mesh, and the points at which every system is asked.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "cdfr/core/result.h"
#include "cdfr/core/types.h"
#include "cdfr/mesh/mesh.h"
#include "models.h"
#include "sample_grid.h"

namespace cdfr::bench {

/// How much is measured.
struct Effort {
  std::size_t points = 100'000;  ///< of each kind of single query
  std::size_t batch_points = 1'000'000;
  std::uint32_t slabs = 1;  ///< of the grid that cdfr fills: one is all of it
  std::uint32_t slab_planes = 256;
  int rounds = 5;
  int build_rounds = 5;
  double checked_triangles = 3e8;  ///< that brute force may look at, for each kind of query
};
/// For a look at one model in some seconds.
Effort quick_effort();

struct Course {
  Mesh mesh;  ///< coordinates rounded to float, which Embree takes; equal vertices made one
  double diagonal = 0;
  std::vector<Vec3> random;  ///< in the mesh's box scaled by 1.1; the first ones of the batch
  std::vector<Vec3> near;    ///< within 1 % of the diagonal from points spread evenly over the surface
  std::vector<Vec3> far;     ///< in the box scaled by 10
  std::vector<Vec3> batch;
  /// 256^3 points over the box scaled by 1.1: all of them, or slabs spread over them.
  std::vector<SampleGrid> grid;
  std::vector<SampleGrid> grid_peers;  ///< four planes of it
};

Result<Course> make_course(const Model& model, const Effort& effort);

}  // namespace cdfr::bench
