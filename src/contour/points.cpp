#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
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

/// A task takes one region, which gives some thousand points as a rule. A wave of tasks is written to the
/// sink in order, so its length changes nothing but how much memory lies ready: some megabytes, which stay in
/// the caches.
constexpr std::size_t regions_a_thread = 8;

Level level_of(const FieldData& field, double distance, Rule rule, double tolerance) noexcept {
  const Box domain = field.tree.lattice.domain();
  const double largest =
      std::max(largest_magnitude(domain.lo), largest_magnitude(domain.hi)) + std::fabs(distance);
  return {std::fabs(distance),
          distance < 0 ? -1.0 : 1.0,
          point_rounding(largest),
          !field.winding.empty(),
          rule,
          tolerance};
}

/// What finds the points of one region after another, and keeps its memory.
struct Worker {
  Worker(const FieldData& field, const Level& level)
      : descent(field, level, points), in_leaf(field, level, descent, points) {}

  void run(const Region& region) {
    points.clear();
    descent.clear_counts();
    in_leaf.clear_counts();
    if (!in_leaf.run(region)) descent.run(region.cube);
  }

  std::vector<ContourPoint> points;
  Descent descent;
  LeafDescent in_leaf;
};

/// In locals, which stay in registers.
void describe(const std::vector<ContourPoint>& points, ContourReport& report) {
  Vec3 lo = report.box.lo, hi = report.box.hi;
  double most = report.max_error;
  for (const ContourPoint& p : points) {
    if (std::isfinite(p.error)) most = std::max(most, p.error);
    lo = {std::min(lo.x, p.position.x), std::min(lo.y, p.position.y), std::min(lo.z, p.position.z)};
    hi = {std::max(hi.x, p.position.x), std::max(hi.y, p.position.y), std::max(hi.z, p.position.z)};
  }
  report.points += points.size();
  report.max_error = most;
  report.box = {lo, hi};
}

class Extraction {
 public:
  Extraction(const FieldData& field, const Level& level, PointSink& sink, Progress& progress)
      : field_(field), level_(level), sink_(sink), progress_(progress) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    report_.box = {{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};
    report_.subvoxel = final_size(level, field.tree.lattice.edge);
    report_.leaves = field.tree.leaves.size();
    const auto threads = static_cast<std::size_t>(tbb::this_task_arena::max_concurrency());
    for (std::size_t i = 0; i < threads * regions_a_thread; ++i)
      workers_.push_back(std::make_unique<Worker>(field, level));
  }

  Result<ContourReport> run() {
    const RegionCounts counts = for_each_region(field_, level_, progress_, [this](const Region& region) {
      wave_.push_back(region);
      if (wave_.size() == workers_.size()) flush();
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
    for_chunks(wave_.size(), 1, [&](std::size_t i, std::size_t) {
      if (progress_.poll()) workers_[i]->run(wave_[i]);
    });
    for (std::size_t i = 0; i < wave_.size(); ++i) {
      if (progress_.cancelled() || !written_) break;
      take(*workers_[i], wave_[i].leaf);
    }
    wave_.clear();
  }

  void take(const Worker& worker, std::uint64_t leaf) {
    for (const DescentCounts& counts : {worker.descent.counts(), worker.in_leaf.counts()}) {
      report_.evaluations += counts.evaluations;
      report_.undecided += counts.undecided;
    }
    if (worker.points.empty()) return;
    if (leaf != Region::no_leaf) {
      report_.productive += leaf != last_productive_;
      last_productive_ = leaf;
    }
    describe(worker.points, report_);
    written_ = sink_.write(worker.points);
  }

  const FieldData& field_;
  const Level& level_;
  PointSink& sink_;
  Progress& progress_;
  std::vector<std::unique_ptr<Worker>> workers_;  ///< one for each region of a wave
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
  const Level level = level_of(data, distance, options.rule, tolerance);
  if (tolerance < 4 * level.rounding) {
    return Error{Code::bad_option, 0, "tolerance must be at least 64 ulp of the largest coordinate"};
  }
  if (distance < 0 && data.sign == Sign::none) {
    return Error{Code::not_closed, 0, "an unsigned field has no inside: no contour at a depth"};
  }
  Progress progress(run);
  progress.watch(data.map.get());
  Result<ContourReport> report = Progress::error();
  with_threads(run, [&] { report = Extraction(data, level, sink, progress).run(); });
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
