/// How inside is told from outside.
#pragma once

#include <cstdint>

namespace cdfr {

/// A signed distance is negative inside. It is always the distance to the nearest triangle, inner walls
/// included. Where a mesh is open the sign changes off the surface too, and the signed distance jumps from d
/// to -d there.
enum class Sign : std::uint8_t {
  automatic,     ///< pseudonormal if the audit finds a closed, outward, embedded surface, else winding
  pseudonormal,  ///< by the normal of the closest feature, certified, exact crossings where undecided. For
                 ///< surfaces that are closed, oriented and embedded; elsewhere it says what the closest
                 ///< feature says, and outside a closed mesh's box what the sign of its volume says
  winding,       ///< inside is where the mesh winds round the point more than half a time (w > 1/2)
  none,          ///< unsigned: distances are never negative
};

}  // namespace cdfr
