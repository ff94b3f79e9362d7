/// Where the cells of a contour's mesh lie in space.
///
/// Planes of the grid are whole numbers of the deepest cells' edge from the origin. The edge is a power of
/// two and the origin a multiple of 2^-12 of it, so that every plane is an exact double, the same from
/// whichever cell it is seen. The fractions by which the origin is off the edge's multiples keep the grid's
/// planes away from planes of the contour, which on made parts lie at round numbers as the grid's would.
#pragma once

#include <array>
#include <cstdint>

#include "cdfr/core/types.h"

namespace cdfr {

/// A corner of the grid in edges of the deepest cells from the origin.
using GridPlace = std::array<std::uint32_t, 3>;

/// Levels that cells may go beyond the finest one, to see what its corners do not show.
inline constexpr int levels_beyond = 2;
/// Coordinates of corners take 21 bits.
inline constexpr int most_levels = 20;

struct SurfaceLattice {
  std::array<double, 3> origin{};
  double step = 1;  ///< edge of the deepest cells
  int deepest = 0;  ///< level of the deepest cells; the root is level 0

  /// The level whose cells have a diagonal of at most the tolerance.
  int finest() const noexcept { return deepest - levels_beyond; }
  /// In steps.
  std::uint32_t width(int level) const noexcept { return std::uint32_t{1} << (deepest - level); }
  double size(int level) const noexcept { return step * width(level); }
  double plane(int axis, std::uint32_t number) const noexcept { return origin[axis] + step * number; }
  Vec3 corner(const GridPlace& p) const noexcept { return {plane(0, p[0]), plane(1, p[1]), plane(2, p[2])}; }
  Vec3 centre(const GridPlace& lo, int level) const noexcept {
    const double half = size(level) / 2;
    return {plane(0, lo[0]) + half, plane(1, lo[1]) + half, plane(2, lo[2]) + half};
  }
};

inline double half_diagonal(double size) noexcept { return 0.8660254037844388 * size; }

/// A lattice whose root holds the box grown by `reach` and more. `deepest` comes out above most_levels, or
/// the step too small for the coordinates (fits()), if the tolerance is too fine.
SurfaceLattice surface_lattice(const Box& box, double reach, double tolerance) noexcept;

/// Are planes exact, with room between them? A step of 2^-30 of the largest coordinate leaves 2^22 doubles in
/// it.
bool fits(const SurfaceLattice& lattice) noexcept;

}  // namespace cdfr
