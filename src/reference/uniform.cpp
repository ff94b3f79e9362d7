#include "cdfr/reference/uniform.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "cdfr/mesh/audit.h"
#include "core/floating_environment.h"
#include "core/parallel.h"
#include "core/progress.h"
#include "geometry/query_range.h"
#include "reference/base_triangle.h"
#include "reference/uniform_data.h"

namespace cdfr {
namespace {

Error bad_option(const std::string& text) { return {Code::bad_option, 0, text}; }

Result<VoxelGrid> grid_for(const Box& mesh, const UniformOptions& options) {
  if (options.resolution < 1 || options.resolution > 65536)
    return bad_option("resolution must be 1 to 65536");
  if (options.border < 1 || options.border > 64) return bad_option("border must be 1 to 64");
  const std::array<double, 3> sides{mesh.hi.x - mesh.lo.x, mesh.hi.y - mesh.lo.y, mesh.hi.z - mesh.lo.z};
  const double longest = *std::ranges::max_element(sides);
  if (!(longest > 0)) return bad_option("a mesh of no size has no uniform field");
  VoxelGrid grid;
  grid.size = longest / options.resolution;
  const double before = (options.border + (options.voxels == UniformVoxels::points ? 0.5 : 0.0)) * grid.size;
  grid.origin = {mesh.lo.x - before, mesh.lo.y - before, mesh.lo.z - before};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    // The longest side is to have `resolution` voxels whichever way the quotient rounds.
    const int along = static_cast<int>(std::ceil(sides[axis] / grid.size * (1 - 0x1p-40)));
    grid.counts[axis] = std::max(along, 1) + 2 * options.border;
  }
  if (grid.cell_count() > most_uniform_cells) {
    return bad_option("more than " + std::to_string(most_uniform_cells) + " voxels: take a lower resolution");
  }
  const Vec3 end = grid.at(grid.counts[0], grid.counts[1], grid.counts[2]);
  const double largest = std::max(largest_magnitude(grid.origin), largest_magnitude(end));
  grid.slack = point_rounding(largest);
  if (grid.size < 0x1p16 * grid.slack) {
    return Error{Code::out_of_range, 0, "voxels are too small for coordinates of this size"};
  }
  return grid;
}

Result<UniformData> build_data(MeshView mesh, const UniformOptions& options, Progress& progress) {
  const Result<MeshReport> report = audit(mesh);
  if (!report) return report.error();
  Result<VoxelGrid> grid = grid_for(report->box, options);
  if (!grid) return grid.error();
  UniformData data;
  data.options = options;
  data.grid = *grid;
  data.surface = reference_surface(mesh);
  if (const Result<void> done = voxelise(data, progress); !done) return done.error();
  if (options.voxels == UniformVoxels::points) drop_outside_points(data);
  flood_outside(data);
  if (const Result<void> done = propagate(data, progress); !done) return done.error();
  return data;
}

}  // namespace

Result<UniformField> UniformField::build(MeshView mesh, const UniformOptions& options, const Run& run) {
  const FloatingEnvironment environment;
  Progress progress(run);
  Result<UniformData> data = Progress::error();
  with_threads(run, [&] { data = build_data(mesh, options, progress); });
  if (!data) return data.error();
  return UniformField(std::make_shared<const UniformData>(std::move(data).value()));
}

std::array<int, 3> UniformField::counts() const noexcept { return data_->grid.counts; }
std::size_t UniformField::cell_count() const noexcept { return data_->sides.size(); }
double UniformField::voxel() const noexcept { return data_->grid.size; }
Side UniformField::side(std::size_t cell) const noexcept { return data_->sides[cell]; }
Box UniformField::box(std::size_t cell) const noexcept { return data_->grid.box(data_->grid.place(cell)); }
std::span<const CddTuple> UniformField::list(std::size_t cell) const noexcept { return data_->lists[cell]; }
UniformOptions UniformField::options() const noexcept { return data_->options; }

std::optional<std::size_t> UniformField::locate(Vec3 x) const noexcept {
  const FloatingEnvironment environment;
  const auto place = data_->grid.locate(x);
  if (!place) return std::nullopt;
  return data_->grid.number(*place);
}

UniformClosest UniformField::closest(Vec3 x) const noexcept {
  const FloatingEnvironment environment;
  const std::optional<std::size_t> cell = locate(x);
  return closest_among(data_->surface, x, cell ? list(*cell) : std::span<const CddTuple>());
}

UniformStats UniformField::stats() const noexcept {
  UniformStats stats;
  stats.rounds = data_->rounds;
  stats.measured = data_->measured;
  for (std::size_t cell = 0; cell < cell_count(); ++cell) {
    const std::size_t tuples = list(cell).size();
    const Side where = side(cell);
    ++(where == Side::inside    ? stats.inside_cells
       : where == Side::surface ? stats.surface_cells
                                : stats.outside_cells);
    (where == Side::inside    ? stats.inside_tuples
     : where == Side::surface ? stats.surface_tuples
                              : stats.outside_tuples) += tuples;
    stats.stated_bytes += tuples > 0 ? 4 * tuples + 5 : 1;
  }
  return stats;
}

}  // namespace cdfr
