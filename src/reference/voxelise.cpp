#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

#include "geometry/point_triangle.h"
#include "geometry/triangle_box.h"
#include "reference/base_triangle.h"
#include "reference/uniform_data.h"

namespace cdfr {
namespace {

Box grown(const Box& box, double by) noexcept {
  return {{box.lo.x - by, box.lo.y - by, box.lo.z - by}, {box.hi.x + by, box.hi.y + by, box.hi.z + by}};
}

/// Places that the triangle's box reaches, one more on each side: all whose point is less than 3/2 voxels
/// from it.
std::array<std::array<int, 2>, 3> range_of(const VoxelGrid& grid, const std::array<Vec3, 3>& corners) {
  const auto along = [&](double Vec3::*axis, std::size_t a) {
    const auto [lo, hi] = std::minmax({corners[0].*axis, corners[1].*axis, corners[2].*axis});
    const double first = (lo - grid.origin.*axis) / grid.size, last = (hi - grid.origin.*axis) / grid.size;
    return std::array<int, 2>{std::max(static_cast<int>(first) - 1, 0),
                              std::min(static_cast<int>(last) + 1, grid.counts[a] - 1)};
  };
  return {along(&Vec3::x, 0), along(&Vec3::y, 1), along(&Vec3::z, 2)};
}

}  // namespace

ReferenceSurface reference_surface(MeshView mesh) {
  ReferenceSurface surface;
  surface.topology = weld_topology(mesh);
  std::vector<std::uint32_t> order(mesh.triangles.size());
  std::iota(order.begin(), order.end(), 0U);
  surface.triangles = gather_triangles(mesh, surface.topology, order);
  surface.first_around.assign(surface.topology.vertex_count + std::size_t{1}, 0);
  for (const Triangle& t : surface.topology.triangles) {
    for (const std::uint32_t v : t) ++surface.first_around[v + std::size_t{1}];
  }
  std::partial_sum(surface.first_around.begin(), surface.first_around.end(), surface.first_around.begin());
  std::vector<std::uint64_t> next = surface.first_around;
  surface.around.resize(next.back());
  for (std::uint32_t t = 0; t < surface.topology.triangles.size(); ++t) {
    for (const std::uint32_t v : surface.topology.triangles[t]) surface.around[next[v]++] = t;
  }
  return surface;
}

Result<void> expect_few_enough(std::uint64_t tuples) {
  if (tuples <= most_uniform_tuples) return {};
  return Error{Code::out_of_range, tuples,
               "more than " + std::to_string(most_uniform_tuples) + " tuples: take a lower resolution"};
}

CddTuple cdd_tuple(const ReferenceSurface& surface, const Vec3& centre, std::uint32_t triangle) noexcept {
  return {square_root(measure(centre, surface.triangles.shape(triangle)).squared), triangle};
}

Result<void> voxelise(UniformData& data, Progress& progress) {
  const VoxelGrid& grid = data.grid;
  data.sides.assign(grid.cell_count(), Side::inside);
  data.lists.resize(grid.cell_count());
  std::uint64_t tuples = 0;
  progress.phase(0, 0.1, data.surface.triangles.size());
  for (std::uint32_t t = 0; t < data.surface.triangles.size(); ++t) {
    const std::array<Vec3, 3> corners = data.surface.triangles.shape(t).vertices;
    const auto [x, y, z] = range_of(grid, corners);
    VoxelGrid::Place p{};
    for (p[2] = z[0]; p[2] <= z[1]; ++p[2]) {
      if (!progress.poll()) return Progress::error();
      for (p[1] = y[0]; p[1] <= y[1]; ++p[1]) {
        for (p[0] = x[0]; p[0] <= x[1]; ++p[0]) {
          const bool near = data.options.voxels == UniformVoxels::points;
          if (!near && !may_touch(corners, grown(grid.box(p), grid.slack))) continue;
          const CddTuple tuple = cdd_tuple(data.surface, grid.centre(p), t);
          if (near && tuple.distance > grid.size + grid.slack) continue;
          const std::size_t cell = grid.number(p);
          data.sides[cell] = Side::surface;
          data.lists[cell].push_back(tuple);
          ++tuples;
        }
      }
    }
    if (Result<void> fits = expect_few_enough(tuples); !fits) return fits;
    progress.step();
  }
  for (auto& list : data.lists) {
    std::ranges::sort(list, {}, [](const CddTuple& a) { return std::pair(a.distance, a.triangle); });
  }
  return {};
}

void drop_outside_points(UniformData& data) {
  for (std::size_t cell = 0; cell < data.lists.size(); ++cell) {
    if (data.sides[cell] != Side::surface) continue;
    const Vec3 point = data.grid.centre(data.grid.place(cell));
    if (closest_among(data.surface, point, data.lists[cell]).distance <= data.grid.slack) continue;
    data.sides[cell] = Side::outside;
    if (!data.options.keep_outside) std::vector<CddTuple>().swap(data.lists[cell]);
  }
}

}  // namespace cdfr
