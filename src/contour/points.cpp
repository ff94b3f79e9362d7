#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "cdfr/contour/contour.h"
#include "contour/descent.h"
#include "contour/regions.h"
#include "core/floating_environment.h"
#include "core/parallel.h"
#include "core/progress.h"
#include "geometry/query_range.h"

namespace cdfr {
namespace {

/// Cubes a task takes, and tasks between two writes to the sink: fixed, so that nothing depends on threads.
constexpr std::size_t cubes_a_task = 32;
constexpr std::size_t tasks_a_wave = 64;

double longest_side(const Box& box) noexcept {
  return std::max({box.hi.x - box.lo.x, box.hi.y - box.lo.y, box.hi.z - box.lo.z});
}

Level level_of(const FieldData& field, double distance) noexcept {
  const Box domain = field.tree.lattice.domain();
  const double largest =
      std::max(largest_magnitude(domain.lo), largest_magnitude(domain.hi)) + std::fabs(distance);
  return {std::fabs(distance), distance < 0 ? -1.0 : 1.0, 16 * std::ldexp(1.0, std::ilogb(largest) - 52)};
}

struct Found {
  std::vector<ContourPoint> points;
  DescentCounts counts;
};

Found descend_into(const FieldData& field, const Level& level, double tolerance, std::span<const Cube> cubes,
                   Progress& progress) {
  Found found;
  Descent descent(field, level, tolerance, found.points);
  for (const Cube& cube : cubes) {
    if (progress.cancelled()) break;
    descent.run(cube);
  }
  found.counts = descent.counts();
  progress.step();
  return found;
}

void describe(const std::vector<ContourPoint>& points, ContourReport& report) {
  report.points += points.size();
  for (const ContourPoint& p : points) {
    report.max_error = std::max(report.max_error, p.error);
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
    report_.leaves = field.first_leaf.back();
  }

  Result<ContourReport> run() {
    const Regions regions = regions_of(field_, level_);
    const auto tasks = [](std::size_t cubes) { return (cubes + cubes_a_task - 1) / cubes_a_task; };
    progress_.phase(0, 1, static_cast<double>(tasks(regions.leaves.size()) + tasks(regions.beyond.size())));
    DescentCounts leaves, beyond;
    if (Result<void> done = extract(regions.leaves, leaves); !done) return done.error();
    if (Result<void> done = extract(regions.beyond, beyond); !done) return done.error();
    report_.visited = leaves.visited;
    report_.productive = leaves.productive;
    leaves.add(beyond);
    report_.evaluations = leaves.evaluations;
    report_.undecided = leaves.undecided;
    return report_;
  }

 private:
  Result<void> extract(std::span<const Cube> cubes, DescentCounts& counts) {
    for (std::size_t first = 0; first < cubes.size(); first += cubes_a_task * tasks_a_wave) {
      const std::span<const Cube> wave =
          cubes.subspan(first, std::min(cubes.size() - first, cubes_a_task * tasks_a_wave));
      std::vector<Found> found((wave.size() + cubes_a_task - 1) / cubes_a_task);
      for_chunks(wave.size(), cubes_a_task, [&](std::size_t begin, std::size_t end) {
        found[begin / cubes_a_task] =
            descend_into(field_, level_, tolerance_, wave.subspan(begin, end - begin), progress_);
      });
      if (progress_.cancelled()) return Progress::error();
      for (const Found& part : found) {
        counts.add(part.counts);
        describe(part.points, report_);
        if (part.points.empty()) continue;
        if (Result<void> written = sink_.write(part.points); !written) return written;
      }
    }
    return {};
  }

  const FieldData& field_;
  const Level& level_;
  double tolerance_;
  PointSink& sink_;
  Progress& progress_;
  ContourReport report_;
};

class Collector : public PointSink {
 public:
  Result<void> write(std::span<const ContourPoint> points) override {
    collected.insert(collected.end(), points.begin(), points.end());
    return {};
  }
  std::vector<ContourPoint> collected;
};

}  // namespace

Result<ContourReport> contour_points(const Field& field, double distance, const ContourOptions& options,
                                     PointSink& sink, const Run& run) {
  const FloatingEnvironment environment;
  const FieldData& data = field.data();
  const double longest = longest_side(data.bounds());
  const double tolerance = options.tolerance == 0 ? longest / 1000 : options.tolerance;
  if (!std::isfinite(distance)) return Error{Code::bad_option, 0, "distance must be finite"};
  if (!(tolerance > 0) || !std::isfinite(tolerance) || tolerance < longest * 0x1p-40) {
    return Error{Code::bad_option, 0, "tolerance must be at least 2^-40 of the longest side"};
  }
  if (distance < 0 && data.sign == Sign::none) {
    return Error{Code::not_closed, 0, "an unsigned field has no inside: no contour at a depth"};
  }
  const Level level = level_of(data, distance);
  Progress progress(run);
  Result<ContourReport> report = Progress::error();
  with_threads(run, [&] { report = Extraction(data, level, tolerance, sink, progress).run(); });
  return report;
}

Result<std::vector<ContourPoint>> contour_points(const Field& field, double distance,
                                                 const ContourOptions& options, const Run& run) {
  Collector collector;
  const Result<ContourReport> report = contour_points(field, distance, options, collector, run);
  if (!report) return report.error();
  return std::move(collector.collected);
}

}  // namespace cdfr
