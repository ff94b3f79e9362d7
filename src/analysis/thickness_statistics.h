/// Statistics of thickness, weighted by area.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "cdfr/analysis/thickness.h"

namespace cdfr {

struct WeightedValue {
  double value = 0, weight = 0;
};

/// Thickness and area of the wanted samples that have met something, ascending by thickness.
template <class Wanted>
std::vector<WeightedValue> weighted_thickness(std::span<const ThicknessSample> samples, Wanted wanted) {
  std::vector<WeightedValue> values;
  for (const ThicknessSample& sample : samples) {
    if (!std::isnan(sample.thickness) && wanted(sample)) values.push_back({sample.thickness, sample.area});
  }
  std::stable_sort(values.begin(), values.end(),
                   [](const WeightedValue& a, const WeightedValue& b) { return a.value < b.value; });
  return values;
}

/// The least value that at least `share` of the weight does not exceed; NaN if there are none. Precondition:
/// ascending.
double quantile(std::span<const WeightedValue> values, double share) noexcept;

/// Fills in counts, area, least to greatest, quantiles and histogram. O(n log n).
void describe_thickness(std::span<const ThicknessSample> samples, int bins, ThicknessReport& report);

}  // namespace cdfr
