#include "cdfr/analysis/thickness.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "analysis/edge_samples.h"
#include "analysis/facet_estimate.h"
#include "analysis/sample_neighbours.h"
#include "analysis/smooth_regions.h"
#include "analysis/surface_samples.h"
#include "analysis/thickness_statistics.h"
#include "analysis/thin_places.h"
#include "analysis/triangle_edges.h"
#include "analysis/wall_survey.h"
#include "core/floating_environment.h"
#include "core/parallel.h"

namespace cdfr {
namespace {

ThicknessSample joined(const FieldData& field, const SurfaceSample& at, const MeasuredWall& wall) noexcept {
  ThicknessSample sample;
  sample.position = at.position;
  sample.normal = at.normal;
  sample.area = at.area;
  sample.facet = at.facet;
  sample.triangle = field.triangles.records[at.slot].number;
  sample.patch = field.triangles.exact[at.slot].patch;
  sample.thickness = wall.thickness;
  sample.error = wall.error;
  sample.opposite_point = wall.opposite_point;
  sample.opposite = wall.opposite;
  sample.opposite_patch = wall.opposite_patch;
  return sample;
}

/// Everything between options and result, in the caller's task arena.
class Measurement {
 public:
  Measurement(const FieldData& field, const ThicknessOptions& options, Progress& progress)
      : field_(field),
        options_(options),
        progress_(progress),
        edges_(field.triangles),
        slots_(slots_by_number(field.triangles)) {}

  Result<Thickness> run() {
    ThicknessReport& report = result_.report;
    const WallSurvey survey(field_, options_);
    if (const Result<void> checked = survey.check(); !checked) return checked.error();
    report.error = survey.error();
    report.largest = survey.largest();
    report.rounding = survey.rounding();
    if (const Result<void> sampled = sample(survey); !sampled) return sampled.error();
    if (field_.failed()) return field_.status().error();
    if (!progress_.poll()) return Progress::error();
    if (options_.method == ThicknessMethod::ray) report.error = largest_error();
    settle_edges();
    describe_thickness(result_.samples, options_.bins, report);
    find_thin_places(result_.samples, {field_.triangles, edges_, slots_, options_.at}, options_, report);
    return std::move(result_);
  }

 private:
  /// By slot: as it was given, or estimated.
  std::vector<double> facets() {
    if (options_.method == ThicknessMethod::ray) return std::vector<double>(field_.triangles.size(), 0);
    if (options_.facet >= 0) return std::vector<double>(field_.triangles.size(), options_.facet);
    FacetErrors errors = estimate_facets(field_, edges_, options_.sharp);
    result_.report.facet_estimate = errors.estimate;
    return std::move(errors.by_slot);
  }

  Result<void> sample(const WallSurvey& survey) {
    const auto places = surface_samples(field_, slots_, facets(), options_.at, options_.spacing);
    if (!places) return places.error();
    progress_.phase(0, 1, WallSurvey::steps(places->size()));
    const double sign = options_.clearance ? 1 : -1;
    std::vector<WallPoint> points;
    points.reserve(places->size());
    for (const SurfaceSample& at : *places) {
      const Vec3 direction{sign * at.normal.x, sign * at.normal.y, sign * at.normal.z};
      points.push_back({at.position, direction, at.slot, at.facet});
      result_.report.facet = std::max(result_.report.facet, at.facet);
    }
    std::vector<MeasuredWall> walls(points.size());
    result_.report.queries = survey.measure(points, walls, progress_);
    result_.samples.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
      result_.samples.push_back(joined(field_, (*places)[i], walls[i]));
    return {};
  }

  double largest_error() const noexcept {
    double error = 0;
    for (const ThicknessSample& s : result_.samples) error = std::max(error, s.error);
    return error;
  }

  /// In a gap it is a concave edge of the part that holds the ball.
  void settle_edges() {
    const SmoothRegions regions(field_.triangles, edges_, options_.sharp,
                                options_.clearance ? Bend::concave : Bend::convex);
    auto& samples = result_.samples;
    mark_edge_samples(field_.triangles, regions, slots_, options_.at, samples);
    result_.report.regions = regions.count();
    if (options_.edges == EdgePolicy::extrapolate)
      result_.report.extrapolated = extrapolate_edge_samples(regions, slots_, samples);
    if (options_.edges == EdgePolicy::skip)
      result_.report.skipped = std::erase_if(samples, [](const ThicknessSample& s) { return s.at_edge; });
  }

  const FieldData& field_;
  ThicknessOptions options_;
  Progress& progress_;
  TriangleEdges edges_;
  std::vector<std::uint32_t> slots_;
  Thickness result_;
};

}  // namespace

Result<Thickness> thickness(const Field& field, const ThicknessOptions& options, const Run& run) {
  const FloatingEnvironment environment;
  const FieldData& data = field.data();
  if (const Result<void> checked = check_thickness(data, options); !checked) return checked.error();
  Progress progress(run);
  progress.watch(data.map.get());
  Result<Thickness> result = Progress::error();
  with_threads(run, [&] {
    if (progress.poll()) result = Measurement(data, options, progress).run();
  });
  if (data.failed()) return data.status().error();
  return result;
}

}  // namespace cdfr
