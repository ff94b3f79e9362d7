#include "contour/surface_lattice.h"

#include <algorithm>
#include <cmath>

#include "geometry/box_distance.h"

namespace cdfr {
namespace {

/// Of the room between box and root, what lies before the box; no simple ratios among them.
constexpr std::array<double, 3> share_before{0.3819660112501051, 0.4450418679126287, 0.4142135623730950};

}  // namespace

SurfaceLattice surface_lattice(const Box& box, double reach, double tolerance) noexcept {
  SurfaceLattice lattice;
  lattice.step = std::ldexp(1.0, std::ilogb(tolerance));
  while (2 * half_diagonal(lattice.step) > tolerance) lattice.step /= 2;
  lattice.step = std::ldexp(lattice.step, -levels_beyond);
  lattice.deepest = levels_beyond;
  const double needed = longest_side(box) + 2 * reach + 8 * tolerance;
  while (lattice.size(0) < needed && lattice.deepest <= most_levels) ++lattice.deepest;
  const double grain = std::ldexp(lattice.step, -12);
  const std::array<double, 3> lo{box.lo.x, box.lo.y, box.lo.z}, hi{box.hi.x, box.hi.y, box.hi.z};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double room = lattice.size(0) - (hi[axis] - lo[axis]);
    lattice.origin[axis] = std::floor((lo[axis] - share_before[axis] * room) / grain) * grain;
  }
  return lattice;
}

bool fits(const SurfaceLattice& lattice) noexcept {
  if (lattice.deepest > most_levels) return false;
  double largest = 0;
  for (int axis = 0; axis < 3; ++axis) {
    largest = std::max(
        {largest, std::fabs(lattice.origin[axis]), std::fabs(lattice.plane(axis, lattice.width(0)))});
  }
  return lattice.step >= std::ldexp(largest, -30);
}

}  // namespace cdfr
