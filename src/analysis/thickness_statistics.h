/// Statistics of thickness, weighted by area.
#pragma once

#include <span>
#include <vector>

#include "cdfr/analysis/thickness.h"

namespace cdfr {

struct WeightedValue {
  double value = 0, weight = 0;
};

/// Thickness and area of the samples that have met something, ascending by thickness; without those at edges
/// if they are not wanted.
std::vector<WeightedValue> weighted_thickness(std::span<const ThicknessSample> samples, bool with_edges);

/// The least value that at least `share` of the weight does not exceed; NaN if there are none. Precondition:
/// ascending.
double quantile(std::span<const WeightedValue> values, double share) noexcept;

/// Fills in counts, area, least to greatest, quantiles and histogram. O(n log n).
void describe_thickness(std::span<const ThicknessSample> samples, int bins, ThicknessReport& report);

}  // namespace cdfr
