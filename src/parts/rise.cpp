#include "parts/rise.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "parts/outline.h"

namespace cdfr {

double risen(double z, std::span<const Rise> rises) noexcept {
  std::size_t above = 1;
  while (above + 1 < rises.size() && rises[above].level <= z) ++above;
  const Rise &low = rises[above - 1], &high = rises[above];
  const double share = (z - low.level) / (high.level - low.level);
  const double lifted = z + low.by + share * (high.by - low.by);
  return std::floor(lifted * plan_units + 0.5) / plan_units;
}

double fade(double value, double from, double to) noexcept {
  return std::clamp((to - value) / (to - from), 0.0, 1.0);
}

double half_chord(double radius, double offset) noexcept {
  return std::sqrt(std::max(0.0, radius * radius - offset * offset));
}

}  // namespace cdfr
