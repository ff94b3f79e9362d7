#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "cdfr/contour/contour.h"
#include "contour/descent.h"
#include "contour/leaf_descent.h"
#include "contour/regions.h"
#include "core/collected_points.h"
#include "core/floating_environment.h"
#include "core/parallel.h"
#include "core/progress.h"
#include "geometry/box_distance.h"
#include "geometry/query_range.h"

namespace cdfr {
namespace {

/// Regions a task takes, and regions between two writes to the sink: fixed, so that nothing depends on
/// threads. A region gives some thousand points as a rule, so a wave takes tens of megabytes.
constexpr std::size_t regions_a_task = 2;
constexpr std::size_t regions_a_wave = 128;

Level level_of(const FieldData& field, double distance) noexcept {
  const Box domain = field.tree.lattice.domain();
  const double largest =
      std::max(largest_magnitude(domain.lo), largest_magnitude(domain.hi)) + std::fabs(distance);
  return {std::fabs(distance), distance < 0 ? -1.0 : 1.0, 16 * std::ldexp(1.0, std::ilogb(largest) - 52),
          !field.winding.empty()};
}

struct Found {
  std::vector<ContourPoint> points;
  std::vector<std::uint64_t> productive;  ///< leaves that gave a point, ascending
  DescentCounts counts;
};

Found descend_into(const FieldData& field, const Level& level, double tolerance,
                   std::span<const Region> regions, Progress& progress) {
  Found found;
  Descent descent(field, level, tolerance, found.points);
  LeafDescent in_leaf(field, level, tolerance, descent, found.points);
  for (const Region& region : regions) {
    if (!progress.poll()) break;
    const std::size_t before = found.points.size();
    if (!in_leaf.run(region)) descent.run(region.cube);
    if (found.points.size() > before && region.leaf != Region::no_leaf)
      found.productive.push_back(region.leaf);
  }
  found.counts = descent.counts();
  found.counts.add(in_leaf.counts());
  return found;
}

void describe(const std::vector<ContourPoint>& points, ContourReport& report) {
  report.points += points.size();
  for (const ContourPoint& p : points) {
    if (std::isfinite(p.error)) report.max_error = std::max(report.max_error, p.error);
    report.box = {{std::min(report.box.lo.x, p.position.x), std::min(report.box.lo.y, p.position.y),
                   std::min(report.box.lo.z, p.position.z)},
                  {std::max(report.box.hi.x, p.position.x), std::max(report.box.hi.y, p.position.y),
                   std::max(report.box.hi.z, p.position.z)}};
  }
}

double subvoxel_of(const Lattice& lattice, double tolerance) noexcept {
  Cube cube{{}, lattice.edge};
  while (cube.half_diagonal() > tolerance / 2) cube.size /= 2;
  return cube.size;
}

class Extraction {
 public:
  Extraction(const FieldData& field, const Level& level, double tolerance, PointSink& sink,
             Progress& progress)
      : field_(field), level_(level), tolerance_(tolerance), sink_(sink), progress_(progress) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    report_.box = {{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};
    report_.subvoxel = subvoxel_of(field.tree.lattice, tolerance);
    report_.leaves = field.tree.leaves.size();
  }

  Result<ContourReport> run() {
    const RegionCounts counts =
        for_each_region(field_, level_, tolerance_, progress_, [this](const Region& region) {
          wave_.push_back(region);
          if (wave_.size() == regions_a_wave) flush();
          return static_cast<bool>(written_) && !progress_.cancelled();
        });
    if (!progress_.cancelled()) flush();
    if (field_.failed()) return field_.status().error();
    if (progress_.cancelled()) return Progress::error();
    if (!written_) return written_.error();
    report_.visited = counts.visited;
    report_.evaluations += counts.evaluations;
    return report_;
  }

 private:
  void flush() {
    std::vector<Found> found((wave_.size() + regions_a_task - 1) / regions_a_task);
    for_chunks(wave_.size(), regions_a_task, [&](std::size_t first, std::size_t end) {
      const std::span<const Region> task = std::span<const Region>(wave_).subspan(first, end - first);
      found[first / regions_a_task] = descend_into(field_, level_, tolerance_, task, progress_);
    });
    wave_.clear();
    for (const Found& part : found) {
      if (progress_.cancelled() || !written_) return;
      report_.evaluations += part.counts.evaluations;
      report_.undecided += part.counts.undecided;
      for (const std::uint64_t leaf : part.productive) {
        report_.productive += leaf != last_productive_;
        last_productive_ = leaf;
      }
      describe(part.points, report_);
      if (!part.points.empty()) written_ = sink_.write(part.points);
    }
  }

  const FieldData& field_;
  const Level& level_;
  double tolerance_;
  PointSink& sink_;
  Progress& progress_;
  std::vector<Region> wave_;
  Result<void> written_;
  std::uint64_t last_productive_ = Region::no_leaf;
  ContourReport report_;
};

}  // namespace

Result<ContourReport> contour_points(const Field& field, double distance, const ContourOptions& options,
                                     PointSink& sink, const Run& run) {
  const FloatingEnvironment environment;
  const FieldData& data = field.data();
  const double longest = longest_side(data.bounds());
  const double tolerance = options.tolerance == 0 ? longest / 1000 : options.tolerance;
  if (!std::isfinite(distance)) return Error{Code::bad_option, 0, "distance must be finite"};
  if (options.tolerance == 0 && longest == 0)
    return Error{Code::bad_option, 0, "a mesh of no size needs a tolerance"};
  if (!(tolerance > 0) || !std::isfinite(tolerance) || tolerance < longest * 0x1p-40) {
    return Error{Code::bad_option, 0, "tolerance must be at least 2^-40 of the longest side"};
  }
  if (tolerance < 4 * level_of(data, distance).rounding) {
    return Error{Code::bad_option, 0, "tolerance must be at least 64 ulp of the largest coordinate"};
  }
  if (distance < 0 && data.sign == Sign::none) {
    return Error{Code::not_closed, 0, "an unsigned field has no inside: no contour at a depth"};
  }
  const Level level = level_of(data, distance);
  Progress progress(run);
  progress.watch(data.map.get());
  Result<ContourReport> report = Progress::error();
  with_threads(run, [&] { report = Extraction(data, level, tolerance, sink, progress).run(); });
  return report;
}

Result<std::vector<ContourPoint>> contour_points(const Field& field, double distance,
                                                 const ContourOptions& options, const Run& run) {
  CollectedPoints collected;
  const Result<ContourReport> report = contour_points(field, distance, options, collected, run);
  if (!report) return report.error();
  return std::move(collected.points);
}

}  // namespace cdfr
