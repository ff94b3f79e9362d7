/// Where cells lie in space: all corners down to the deepest level are exact doubles.
#pragma once

#include <array>
#include <cstdint>

#include "cdfr/core/types.h"
#include "octree/key.h"

namespace cdfr {

struct Lattice {
  Vec3 origin;                                   ///< a multiple of the deepest cells' edge
  double edge = 1;                               ///< of a level 0 cell, a power of two
  std::array<std::uint32_t, 3> bricks{1, 1, 1};  ///< level 0 cells along each axis, 1 to 8

  /// Edge of a cell of that level.
  double size(int level) const noexcept;
  Box box(const Cell& cell) const noexcept;
  Vec3 centre(const Cell& cell) const noexcept;
  /// The brick.
  Box domain() const noexcept;
  /// True if some of the cell lies in the brick; for levels below 0 a part may stick out.
  bool meets_brick(const Cell& cell) const noexcept;
  /// Bound R on the distance from any point of the virtual cube to any vertex in the brick, for rounding
  /// bounds.
  double reach() const noexcept { return 14 * edge; }
  /// Four ulp at the largest coordinate of the brick: how far cells are grown in the definition of complete.
  double grown() const noexcept;
};

/// The lattice for a mesh: the smallest power-of-two cubes of which at most eight in a row cover the box
/// grown by `margin` times its longest side, large enough that corners are exact: 2^-34 of the largest
/// coordinate.
Lattice lattice_for(const Box& mesh, double margin) noexcept;

}  // namespace cdfr
