#include "parts/recipe.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <utility>

namespace cdfr {

void Recipe::fill(Outline outline, double low, double high) {
  steps.push_back({std::move(outline), low, high, true});
}

void Recipe::empty(Outline outline, double low, double high) {
  steps.push_back({std::move(outline), low, high, false});
}

std::vector<double> heights_of(std::span<const Step> steps) {
  std::vector<double> heights;
  for (const Step& step : steps) {
    heights.push_back(step.low);
    heights.push_back(step.high);
  }
  std::sort(heights.begin(), heights.end());
  heights.erase(std::unique(heights.begin(), heights.end()), heights.end());
  return heights;
}

std::uint64_t layers_of(const Step& step, std::span<const double> levels) noexcept {
  assert(levels.size() <= 65);
  std::uint64_t layers = 0;
  for (std::size_t k = 0; k + 1 < levels.size(); ++k) {
    if (levels[k] >= step.low && levels[k] < step.high) layers |= std::uint64_t{1} << k;
  }
  return layers;
}

}  // namespace cdfr
