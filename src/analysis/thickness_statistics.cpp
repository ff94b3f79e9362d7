#include "analysis/thickness_statistics.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace cdfr {
namespace {

/// Precondition: ascending, not empty.
std::vector<double> histogram_of(std::span<const WeightedValue> values, int bins) {
  const double least = values.front().value, width = (values.back().value - least) / bins;
  std::vector<double> histogram(static_cast<std::size_t>(bins), 0.0);
  for (const WeightedValue& v : values) {
    const double place = width > 0 ? std::floor((v.value - least) / width) : 0;
    histogram[static_cast<std::size_t>(std::min(place, bins - 1.0))] += v.weight;
  }
  return histogram;
}

}  // namespace

double quantile(std::span<const WeightedValue> values, double share) noexcept {
  double total = 0, below = 0;
  for (const WeightedValue& v : values) total += v.weight;
  for (const WeightedValue& v : values) {
    below += v.weight;
    if (below >= share * total) return v.value;
  }
  return values.empty() ? std::numeric_limits<double>::quiet_NaN() : values.back().value;
}

void describe_thickness(std::span<const ThicknessSample> samples, int bins, ThicknessReport& report) {
  const std::vector<WeightedValue> values =
      weighted_thickness(samples, [](const ThicknessSample&) { return true; });
  report.samples = values.size();
  report.unmet = samples.size() - values.size();
  for (const ThicknessSample& sample : samples) report.at_edge += sample.at_edge;
  double sum = 0;
  for (const WeightedValue& v : values) {
    report.area += v.weight;
    sum += v.value * v.weight;
  }
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  report.min = values.empty() ? none : values.front().value;
  report.max = values.empty() ? none : values.back().value;
  report.mean = values.empty() ? none : sum / report.area;
  const struct {
    double share;
    double& at;
  } wanted[] = {{0.01, report.p1},  {0.05, report.p5},  {0.25, report.p25}, {0.50, report.p50},
                {0.75, report.p75}, {0.95, report.p95}, {0.99, report.p99}};
  for (const auto& [share, at] : wanted) at = quantile(values, share);
  if (!values.empty()) report.histogram = histogram_of(values, bins);
}

}  // namespace cdfr
