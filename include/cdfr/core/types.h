/// The plain values that cross the public border. Coordinates are doubles in the mesh's own unit.
#pragma once

#include <array>
#include <cstdint>

namespace cdfr {

struct Vec3 {
  double x = 0, y = 0, z = 0;
  friend bool operator==(const Vec3&, const Vec3&) = default;
};

/// Closed axis-aligned box; lo <= hi in every coordinate.
struct Box {
  Vec3 lo, hi;
  friend bool operator==(const Box&, const Box&) = default;
};

/// Three vertex numbers; the outward normal follows the right hand.
using Triangle = std::array<std::uint32_t, 3>;

/// "No such triangle, patch or vertex"; also the reason why a mesh has at most 2^32 - 2 triangles.
inline constexpr std::uint32_t no_index = 0xffffffffU;

}  // namespace cdfr
