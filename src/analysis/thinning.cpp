#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "analysis/facet_estimate.h"
#include "analysis/sample_neighbours.h"
#include "analysis/triangle_edges.h"
#include "analysis/wall_survey.h"
#include "cdfr/analysis/thickness.h"
#include "core/floating_environment.h"
#include "core/parallel.h"
#include "core/vector.h"
#include "field/batch.h"
#include "geometry/box_distance.h"

namespace cdfr {
namespace {

constexpr std::size_t chunk = 2048;

/// Cosine of 60 degrees: a former surface that faces farther away is another wall.
constexpr double least_cosine = 0.5;

class Comparison {
 public:
  Comparison(const FieldData& field, const Thickness& now, const ThicknessOptions& options,
             const FieldData& former, Progress& progress)
      : field_(field), now_(now), options_(options), former_(former), progress_(progress) {}

  Result<Thinning> run(const ThinningOptions& how) {
    const std::vector<std::uint32_t> slots = slots_by_number(former_.triangles);
    const WallSurvey survey(former_, options_);
    if (const Result<void> checked = survey.check(); !checked) return checked.error();
    Thinning result;
    result.reach = how.reach > 0 ? how.reach : longest_side(field_.bounds()) / 100;
    result.change = how.change;
    engine_error_ = survey.error() + now_.report.error;
    find_former_points(slots, result.reach);
    walls_.resize(points_.size());
    progress_.phase(0.3, 1, WallSurvey::steps(points_.size()));
    if (progress_.poll()) survey.measure(points_, walls_, progress_);
    if (former_.failed()) return former_.status().error();
    if (progress_.cancelled()) return Progress::error();
    gather_places(result);
    return result;
  }

 private:
  std::vector<double> former_facets() const {
    if (options_.facet < 0 && options_.method == ThicknessMethod::sphere)
      return estimate_facets(former_, TriangleEdges(former_.triangles), options_.sharp).by_slot;
    const bool ray = options_.method == ThicknessMethod::ray;
    return std::vector<double>(former_.triangles.size(), ray ? 0 : options_.facet);
  }

  /// Where the former surface is closest to each sample, if it is the same wall's.
  void find_former_points(std::span<const std::uint32_t> slots, double reach) {
    const auto& samples = now_.samples;
    progress_.phase(0, 0.3, std::ceil(static_cast<double>(samples.size()) / chunk));
    std::vector<Vec3> positions;
    positions.reserve(samples.size());
    for (const ThicknessSample& sample : samples) positions.push_back(sample.position);
    std::vector<Closest> closest(samples.size());
    for_chunks(samples.size(), chunk, [&](std::size_t first, std::size_t end) {
      const auto out = std::span(closest).subspan(first, end - first);
      if (answer(former_, Points(std::span<const Vec3>(positions)), first, out, progress_)) progress_.step();
    });
    if (progress_.cancelled()) return;
    const double sign = options_.clearance ? 1 : -1;
    const std::vector<double> facets = former_facets();
    for (std::uint32_t i = 0; i < samples.size(); ++i) {
      if (samples[i].at_edge) continue;
      const std::uint32_t slot = slots[closest[i].triangle];
      const Eigen::Vector3d normal = to_eigen(rounded(former_.triangles.shape(slot).normal));
      if (!(std::fabs(closest[i].distance) <= reach)) continue;
      if (!(normal.dot(to_eigen(samples[i].normal)) > least_cosine)) continue;
      points_.push_back({closest[i].point, from_eigen(sign * normal), slot, facets[slot]});
      sample_of_.push_back(i);
    }
  }

  /// A sample's former thickness, and what the difference may be off by.
  struct Former {
    double thickness = std::numeric_limits<double>::quiet_NaN();
    double error = 0;
  };

  ThinnedPlace place_of(std::span<const std::uint32_t> group, std::span<const Former> former) const {
    ThinnedPlace place;
    double most = -std::numeric_limits<double>::infinity();
    for (const std::uint32_t i : group) {
      const ThicknessSample& sample = now_.samples[i];
      place.area += sample.area;
      if (!(former[i].thickness - sample.thickness > most)) continue;
      most = former[i].thickness - sample.thickness;
      place.position = sample.position;
      place.triangle = sample.triangle;
      place.thickness = sample.thickness;
      place.former = former[i].thickness;
      place.error = former[i].error;
    }
    place.samples = group.size();
    return place;
  }

  void gather_places(Thinning& result) const {
    const auto& samples = now_.samples;
    std::vector<Former> former(samples.size());
    for (std::size_t k = 0; k < walls_.size(); ++k) {
      const std::uint32_t i = sample_of_[k];
      former[i] = {walls_[k].thickness, engine_error_ + samples[i].facet + points_[k].facet};
    }
    std::vector<std::uint32_t> thinned;
    for (std::uint32_t i = 0; i < samples.size(); ++i) {
      const double lost = former[i].thickness - samples[i].thickness;
      ++(samples[i].at_edge ? result.at_edge : std::isnan(lost) ? result.unmatched : result.compared);
      if (!(lost > (result.change > 0 ? result.change : former[i].error))) continue;
      thinned.push_back(i);
      result.area += samples[i].area;
    }
    const TriangleEdges edges(field_.triangles);
    const std::vector<std::uint32_t> slots = slots_by_number(field_.triangles);
    const SampleNeighbours neighbours(field_.triangles, edges, slots, options_.at);
    for (const auto& group : neighbours.groups(samples, thinned))
      result.places.push_back(place_of(group, former));
    std::stable_sort(result.places.begin(), result.places.end(),
                     [](const ThinnedPlace& a, const ThinnedPlace& b) {
                       return a.former - a.thickness > b.former - b.thickness;
                     });
  }

  const FieldData& field_;
  const Thickness& now_;
  const ThicknessOptions& options_;
  const FieldData& former_;
  Progress& progress_;
  double engine_error_ = 0;
  std::vector<WallPoint> points_;         ///< on the former surface
  std::vector<std::uint32_t> sample_of_;  ///< by point
  std::vector<MeasuredWall> walls_;       ///< by point
};

}  // namespace

Result<Thinning> thinning(const Field& field, const Thickness& now, const ThicknessOptions& options,
                          const Field& former, const ThinningOptions& how, const Run& run) {
  const FloatingEnvironment environment;
  const auto fits = [](double value) { return value >= 0 && std::isfinite(value); };
  if (!fits(how.reach) || !fits(how.change))
    return Error{Code::bad_option, 0, "reach and change must be 0 or more and finite"};
  if (const Result<void> checked = check_thickness(former.data(), options); !checked) return checked.error();
  Progress progress(run);
  progress.watch(former.data().map.get());
  Result<Thinning> result = Progress::error();
  with_threads(run,
               [&] { result = Comparison(field.data(), now, options, former.data(), progress).run(how); });
  return result;
}

}  // namespace cdfr
