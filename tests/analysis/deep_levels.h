/// What a shape's levels are made from.
#pragma once

#include <functional>
#include <vector>

#include "analysis/shapes.h"

namespace cdfr::test {

/// Volumes of the components of {depth > t} in the solid, by falling ball.
using DeepVolumes = std::function<std::vector<double>(double t)>;

/// The levels at these depths. Precondition: nothing joins, parts or vanishes within the error of them.
inline std::vector<DeepLevel> deep_levels(const DeepVolumes& volumes, const std::vector<double>& depths,
                                          double error) {
  std::vector<DeepLevel> levels;
  for (const double t : depths) {
    const std::vector<double> here = volumes(t), above = volumes(t + error), below = volumes(t - error);
    DeepLevel level{t, {}};
    for (std::size_t i = 0; i < here.size(); ++i) level.regions.push_back({here[i], above[i], below[i]});
    levels.push_back(level);
  }
  return levels;
}

}  // namespace cdfr::test
