#include "reference/extract.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/collected_points.h"
#include "core/floating_environment.h"
#include "core/parallel.h"
#include "reference/base_triangle.h"

namespace cdfr {
namespace {

/// Regions between two writes to the sink: fixed, so that nothing depends on threads.
constexpr std::size_t regions_a_wave = 64;
constexpr int most_subvoxels = 64;

Error bad_option(const char* text) { return {Code::bad_option, 0, text}; }

/// Sub-voxels along a voxel's edge: the fewest that the rule allows. Equation 3 is strict, promise 5 is not.
Result<int> subvoxels_along(const VoxelGrid& grid, const UniformContourOptions& options, double tolerance) {
  const double half_diagonal = half_diagonal_of_unit * grid.size;
  for (int along = 1; along <= most_subvoxels; ++along) {
    const double each = half_diagonal / along;
    if (options.keep == UniformKeep::half_tolerance ? each < tolerance : each <= tolerance / 2) return along;
  }
  return bad_option("tolerance needs more than 64 sub-voxels along a voxel's edge: take a higher resolution");
}

struct Found {
  std::vector<ContourPoint> points;
  std::uint64_t evaluations = 0;
};

class UniformExtraction {
 public:
  UniformExtraction(const UniformData& data, double depth, const UniformContourOptions& options,
                    double tolerance, int along)
      : data_(data), depth_(depth), options_(options), along_(along) {
    report_.subvoxel = data.grid.size / along;
    reach_ = options.keep == UniformKeep::half_tolerance
                 ? tolerance / 2
                 : half_diagonal_of_unit * report_.subvoxel + data.grid.slack;
  }

  Result<UniformContourReport> run(PointSink& sink, Progress& progress) {
    const std::vector<std::size_t> regions =
        between() ? inter_voxels_across(data_, depth_, progress) : voxels_near(data_, depth_);
    report_.regions = data_.lists.size();
    report_.visited = regions.size();
    progress.phase(0, 1, static_cast<double>(regions.size()));
    for (std::size_t first = 0; first < regions.size() && !progress.cancelled(); first += regions_a_wave) {
      std::vector<Found> wave(std::min(regions_a_wave, regions.size() - first));
      for_chunks(wave.size(), 1, [&](std::size_t i, std::size_t) {
        if (!progress.poll()) return;
        wave[i] = divide(regions[first + i]);
        progress.step();
      });
      if (progress.cancelled()) break;
      const Result<void> written = write(wave, sink);
      if (!written) return written.error();
    }
    if (progress.cancelled()) return Progress::error();
    return report_;
  }

 private:
  bool between() const noexcept { return options_.regions == UniformRegions::inter_voxel; }

  Found divide(std::size_t region) const {
    const std::vector<CddTuple> list = between() ? united_lists(data_, region) : data_.lists[region];
    const VoxelGrid::Place p = data_.grid.place(region);
    Found found;
    for (int z = 0; z < along_; ++z) {
      for (int y = 0; y < along_; ++y) {
        for (int x = 0; x < along_; ++x) {
          keep({coordinate(p[0], x), coordinate(p[1], y), coordinate(p[2], z)}, list, found);
        }
      }
    }
    return found;
  }

  /// Of a sub-voxel's centre, in voxels from the grid's origin; one lattice for all regions if their number
  /// is even.
  double coordinate(int place, int sub) const noexcept {
    return (along_ * (place + (between() ? 0.5 : 0.0)) + sub + 0.5) / along_;
  }

  void keep(const Vec3& place, const std::vector<CddTuple>& list, Found& found) const {
    const Vec3 x = data_.grid.at(place.x, place.y, place.z);
    const UniformClosest closest = options_.value == UniformValue::base_triangle
                                       ? closest_among(data_.surface, x, list)
                                       : least_positive_among(data_.surface, x, list);
    ++found.evaluations;
    const double beyond = -closest.distance - depth_;
    if (!(std::fabs(beyond) <= reach_)) return;
    const double error = beyond >= 0 ? beyond + data_.grid.slack : std::numeric_limits<double>::infinity();
    found.points.push_back({x, normal(closest), closest.base, error});
  }

  Vec3 normal(const UniformClosest& closest) const noexcept {
    if (!between()) return closest.normal;
    return rounded(data_.surface.triangles.shape(closest.triangle).normal);
  }

  Result<void> write(const std::vector<Found>& wave, PointSink& sink) {
    for (const Found& found : wave) {
      report_.evaluations += found.evaluations;
      report_.points += found.points.size();
      if (found.points.empty()) continue;
      ++report_.productive;
      if (Result<void> written = sink.write(found.points); !written) return written;
    }
    return {};
  }

  const UniformData& data_;
  double depth_;
  const UniformContourOptions& options_;
  int along_;
  double reach_ = 0;
  UniformContourReport report_;
};

}  // namespace

std::vector<std::size_t> voxels_near(const UniformData& data, double depth) {
  const double reach = half_diagonal_of_unit * data.grid.size + data.grid.slack;
  std::vector<std::size_t> found;
  for (std::size_t cell = 0; cell < data.lists.size(); ++cell) {
    if (data.lists[cell].empty() || std::fabs(data.lists[cell].front().distance - depth) > reach) continue;
    found.push_back(cell);
  }
  return found;
}

Result<UniformContourReport> contour_points(const UniformField& field, double depth,
                                            const UniformContourOptions& options, PointSink& sink,
                                            const Run& run) {
  const FloatingEnvironment environment;
  const UniformData& data = field.data();
  if (!(depth > 0) || !std::isfinite(depth)) return bad_option("depth must be positive and finite");
  if (!(options.tolerance >= 0) || !std::isfinite(options.tolerance)) {
    return bad_option("tolerance must be 0 or more and finite");
  }
  const double longest = data.grid.size * data.options.resolution;
  const double tolerance = options.tolerance == 0 ? longest / 500 : options.tolerance;
  const Result<int> along = subvoxels_along(data.grid, options, tolerance);
  if (!along) return along.error();
  Progress progress(run);
  Result<UniformContourReport> report = Progress::error();
  with_threads(
      run, [&] { report = UniformExtraction(data, depth, options, tolerance, *along).run(sink, progress); });
  return report;
}

Result<std::vector<ContourPoint>> contour_points(const UniformField& field, double depth,
                                                 const UniformContourOptions& options, const Run& run) {
  CollectedPoints collected;
  const Result<UniformContourReport> report = contour_points(field, depth, options, collected, run);
  if (!report) return report.error();
  return std::move(collected.points);
}

}  // namespace cdfr
