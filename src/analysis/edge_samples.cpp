#include "analysis/edge_samples.h"

#include <algorithm>
#include <cmath>

#include "analysis/nearest_point.h"
#include "analysis/sample_neighbours.h"
#include "geometry/box_distance.h"

namespace cdfr {
namespace {

/// Runs of samples by region: `visit` is called with the numbers of each region's samples, ascending.
template <class Visit>
void for_each_region(const SmoothRegions& regions, std::span<const std::uint32_t> slots,
                     std::span<const ThicknessSample> samples, Visit visit) {
  std::vector<std::vector<std::uint32_t>> by_region(regions.count());
  for (std::uint32_t i = 0; i < samples.size(); ++i)
    by_region[regions.region(slots[samples[i].triangle])].push_back(i);
  for (const auto& numbers : by_region) visit(std::span<const std::uint32_t>(numbers));
}

void copy_wall(const ThicknessSample& from, ThicknessSample& to) noexcept {
  to.thickness = from.thickness;
  to.error = from.error;
  to.opposite_point = from.opposite_point;
  to.opposite = from.opposite;
  to.opposite_patch = from.opposite_patch;
  to.opposed = from.opposed;
}

}  // namespace

void mark_edge_samples(const TriangleStore& triangles, const SmoothRegions& regions,
                       std::span<const std::uint32_t> slots, SampleAt at,
                       std::span<ThicknessSample> samples) {
  for (ThicknessSample& sample : samples) {
    const std::uint32_t own = slots[sample.triangle];
    const double chord = distance_between(sample.position, sample.opposite_point) + sample.facet;
    sample.opposed =
        sample.opposite != no_index && chord * chord > 0.75 * sample.thickness * sample.thickness;
    sample.at_edge = sample.opposite != no_index &&
                     regions.adjoin(regions.region(own), regions.region(slots[sample.opposite]));
    if (at == SampleAt::vertices)
      sample.at_edge |= regions.at_edge(vertex_of(triangles, own, sample.position));
  }
}

std::uint64_t extrapolate_edge_samples(const SmoothRegions& regions, std::span<const std::uint32_t> slots,
                                       std::span<ThicknessSample> samples) {
  std::uint64_t set = 0;
  for_each_region(regions, slots, samples, [&](std::span<const std::uint32_t> numbers) {
    std::vector<Vec3> places;
    std::vector<std::uint32_t> sources;
    for (const std::uint32_t i : numbers) {
      if (samples[i].at_edge || std::isnan(samples[i].thickness)) continue;
      places.push_back(samples[i].position);
      sources.push_back(i);
    }
    if (sources.empty()) return;
    const PointTree tree(places);
    for (const std::uint32_t i : numbers) {
      if (!samples[i].at_edge) continue;
      copy_wall(samples[sources[tree.nearest(samples[i].position)]], samples[i]);
      ++set;
    }
  });
  return set;
}

}  // namespace cdfr
