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
  place.facet = thinnest->facet;
  place.triangle = thinnest->triangle;
  place.samples = group.size();
  place.at_edge = thinnest->at_edge;
  place.opposed = thinnest->opposed;
  return place;
}

bool is_wall(const ThicknessSample& sample) noexcept { return sample.opposed && !sample.at_edge; }

/// The thickest of the thinnest twentieth of the walls.
double default_limit(std::span<const ThicknessSample> samples) {
  std::vector<WeightedValue> walls = weighted_thickness(samples, is_wall);
  if (walls.empty()) walls = weighted_thickness(samples, [](const ThicknessSample&) { return true; });
  return quantile(walls, 0.05);
}

}  // namespace

void find_thin_places(std::span<const ThicknessSample> samples, const SampleNeighbours& neighbours,
                      const ThicknessOptions& options, ThicknessReport& report) {
  const bool given = options.thinner_than > 0;
  report.thin_limit = given ? options.thinner_than : default_limit(samples);
  const auto is_thin = [&](const ThicknessSample& sample) {
    return given ? sample.thickness + sample.error < report.thin_limit
                 : sample.thickness - sample.facet - sample.error <= report.thin_limit;
  };
  for (const bool wall : {true, false}) {
    std::vector<std::uint32_t> thin;
    for (std::uint32_t i = 0; i < samples.size(); ++i) {
      if (is_wall(samples[i]) != wall || !is_thin(samples[i])) continue;
      thin.push_back(i);
      report.thin_area += samples[i].area;
      if (wall) report.thin_wall_area += samples[i].area;
    }
    for (const auto& group : neighbours.groups(samples, thin))
      report.places.push_back(place_of(samples, group));
  }
  std::stable_sort(report.places.begin(), report.places.end(), [](const ThinPlace& a, const ThinPlace& b) {
    return a.is_wall() != b.is_wall() ? a.is_wall() : a.thickness < b.thickness;
  });
  report.place_count = report.places.size();
  report.places.resize(std::min(report.places.size(), static_cast<std::size_t>(options.places)));
}

}  // namespace cdfr
