#include "analysis/facet_estimate.h"

#include <algorithm>
#include <vector>

#include "analysis/smooth_regions.h"
#include "analysis/surface_samples.h"
#include "analysis/thickness_statistics.h"
#include "core/arithmetic.h"
#include "geometry/box_distance.h"
#include "geometry/query_range.h"

namespace cdfr {
namespace {

/// tan(a / 4) of an angle in degrees.
double tangent_of_quarter(double degrees) noexcept {
  const double quarter = degrees / (4 * 57.295779513082321);
  return sine(quarter) / cosine(quarter);
}

/// Chord error, and the area that it is of.
WeightedValue curved_part(const TriangleStore& triangles, const TriangleEdges& edges, std::uint32_t slot,
                          double sharp) noexcept {
  WeightedValue part;
  const double area = area_of(triangles.shape(slot));
  for (std::uint32_t k = 0; k < 3 && area > 0; ++k) {
    const std::uint32_t edge = triangles.records[slot].edges[k];
    if (edge == no_index || edges.at(edge).size() != 2) continue;
    const auto sides = edges.at(edge);
    const double turn = turn_in_degrees(triangles, sides[0], sides[1]);
    if (turn > sharp) continue;
    const auto& v = triangles.shape(slot).vertices;
    const double length = distance_between(v[k], v[(k + 1) % 3]);
    const double lesser =
        std::min(area_of(triangles.shape(sides[0].slot)), area_of(triangles.shape(sides[1].slot)));
    part.value += lesser / length * tangent_of_quarter(turn);
    if (turn > 0) part.weight = std::min(area, part.weight + lesser);
  }
  return part;
}

}  // namespace

FacetErrors estimate_facets(const FieldData& field, const TriangleEdges& edges, double sharp) {
  const Box& box = field.bounds();
  // A coordinate is off by 2^-25 of its size where it was rounded to float32, a height by a few of those.
  const double flat = 0x1p-22 * std::max(largest_magnitude(box.lo), largest_magnitude(box.hi));
  FacetErrors errors;
  errors.by_slot.assign(field.triangles.size(), 0);
  std::vector<WeightedValue> curved;
  for (std::uint32_t slot = 0; slot < field.triangles.size(); ++slot) {
    const WeightedValue part = curved_part(field.triangles, edges, slot, sharp);
    if (!(part.value > flat)) continue;
    curved.push_back(part);
    errors.by_slot[slot] = part.value;
  }
  if (curved.empty()) return errors;
  std::stable_sort(curved.begin(), curved.end(),
                   [](const WeightedValue& a, const WeightedValue& b) { return a.value < b.value; });
  errors.estimate = {quantile(curved, 0.5), quantile(curved, 0.99), curved.back().value, curved.size()};
  for (double& error : errors.by_slot) error = std::min(error, errors.estimate.quantile);
  return errors;
}

}  // namespace cdfr
