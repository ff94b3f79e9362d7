/// What is done to a mesh to make it harder.
#pragma once

#include <cstdint>

#include "soak/shape.h"

namespace cdfr::soak {

/// Splits `count` random edges on one side, at the middle raised by `height` of the edge's length; a triangle
/// closes the gap. For height 0 it has no area wherever the midpoint is exact, so bring coarse coordinates.
Mesh capped(Mesh mesh, std::uint64_t count, double height, test::Random& random);

/// With a cube apart from it, so that much of the space around it is inside the box of the mesh, beyond which
/// a side is easily told.
Shape accompanied(Shape shape, test::Random& random);

/// One of: moved away from the origin, scaled, rotated, jittered, stretched, capped, accompanied; `kind` and
/// the random numbers say which and by how much.
Shape changed(Shape shape, std::uint64_t kind, test::Random& random);

}  // namespace cdfr::soak
