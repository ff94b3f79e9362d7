#include "analysis/thin_places.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "analysis/thickness_statistics.h"

namespace cdfr {
namespace {

ThinPlace place_of(std::span<const ThicknessSample> samples, std::span<const std::uint32_t> group) {
  ThinPlace place;
  const ThicknessSample* thinnest = &samples[group.front()];
  for (const std::uint32_t i : group) {
    place.area += samples[i].area;
    if (samples[i].thickness < thinnest->thickness) thinnest = &samples[i];
  }
  place.position = thinnest->position;
  place.thickness = thinnest->thickness;
  place.error = thinnest->error;
  place.triangle = thinnest->triangle;
  place.samples = group.size();
  place.at_edge = thinnest->at_edge;
  return place;
}

/// The thickest of the thinnest twentieth away from edges, and what its tolerances cannot tell from that.
double default_limit(std::span<const ThicknessSample> samples, double tolerance) {
  std::vector<WeightedValue> off_edges = weighted_thickness(samples, false);
  if (off_edges.empty()) off_edges = weighted_thickness(samples, true);
  return quantile(off_edges, 0.05) + tolerance;
}

}  // namespace

void find_thin_places(std::span<const ThicknessSample> samples, const SampleNeighbours& neighbours,
                      const ThicknessOptions& options, ThicknessReport& report) {
  const bool given = options.thinner_than > 0;
  report.thin_limit = given ? options.thinner_than : default_limit(samples, report.error + report.facet);
  const auto is_thin = [&](double thickness) {
    return given ? thickness < report.thin_limit : thickness <= report.thin_limit;
  };
  for (const bool at_edge : {false, true}) {
    std::vector<std::uint32_t> thin;
    for (std::uint32_t i = 0; i < samples.size(); ++i) {
      if (samples[i].at_edge != at_edge || !is_thin(samples[i].thickness)) continue;
      thin.push_back(i);
      report.thin_area += samples[i].area;
      if (!at_edge) report.thin_area_off_edges += samples[i].area;
    }
    for (const auto& group : neighbours.groups(samples, thin))
      report.places.push_back(place_of(samples, group));
  }
  std::stable_sort(report.places.begin(), report.places.end(), [](const ThinPlace& a, const ThinPlace& b) {
    return a.at_edge != b.at_edge ? b.at_edge : a.thickness < b.thickness;
  });
  report.place_count = report.places.size();
  report.places.resize(std::min(report.places.size(), static_cast<std::size_t>(options.places)));
}

}  // namespace cdfr
