#include "octree/level_choice.h"

#include <cmath>

namespace cdfr {

int level_for(double edge, double area, std::uint64_t triangles) noexcept {
  constexpr int least = 5, most = 12;
  const double width = 4 * std::sqrt(area / static_cast<double>(triangles));
  int level = least;
  while (level < most && std::ldexp(edge, -level) > width) ++level;
  return level;
}

}  // namespace cdfr
