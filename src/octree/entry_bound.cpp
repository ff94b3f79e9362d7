#include "octree/entry_bound.h"

#include <algorithm>
#include <cmath>

namespace cdfr {
namespace {

/// Of a corner from the centre, in edges of the leaf.
double side(std::size_t corner, int axis) noexcept { return (corner >> axis & 1U) != 0 ? 0.5 : -0.5; }

}  // namespace

EntryBound entry_bound(const std::array<double, 8>& squared, double distance, double size) noexcept {
  EntryBound bound;
  const double unit = (distance + 2 * size) * EntryBound::step;
  for (int axis = 0; axis < 3; ++axis) {
    double rise = 0;
    for (std::size_t corner = 0; corner < 8; ++corner) rise += side(corner, axis) * squared[corner] / 2;
    bound.slope[axis] = static_cast<std::int8_t>(std::clamp(std::round(rise / (size * unit)), -127.0, 127.0));
  }
  double excess = 0;
  for (std::size_t corner = 0; corner < 8; ++corner) {
    double affine = distance * distance;
    for (int axis = 0; axis < 3; ++axis) affine += unit * bound.slope[axis] * side(corner, axis) * size;
    excess = std::max(excess, affine - (squared[corner] - 0.75 * size * size));
  }
  const double farthest = distance + 3 * size;
  excess += 17 * 0x1p-24 * farthest * farthest;
  const double below = std::ceil(excess / (EntryBound::unit_below * size * size));
  if (!(below < EntryBound::none)) return {};
  bound.below = static_cast<std::uint8_t>(below);
  return bound;
}

}  // namespace cdfr
