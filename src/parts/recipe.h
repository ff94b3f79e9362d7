/// What a solid is made of: outlines filled and emptied one after another.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "parts/outline.h"

namespace cdfr {

/// Fills or empties an outline between two heights, over what earlier steps left there.
struct Step {
  Outline outline;
  double low = 0, high = 0;
  bool solid = true;
};

struct Recipe {
  std::vector<Step> steps;

  void fill(Outline outline, double low, double high);
  void empty(Outline outline, double low, double high);
};

/// The heights at which steps begin or end, ascending.
std::vector<double> heights_of(std::span<const Step> steps);

/// Bit k: the step reaches from levels[k] to levels[k + 1]. At most 65 levels, the step's heights among them.
std::uint64_t layers_of(const Step& step, std::span<const double> levels) noexcept;

}  // namespace cdfr
