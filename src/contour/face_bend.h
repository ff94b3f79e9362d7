/// The point in which a piece of curve bends on its face, where the contour is sharp there.
#pragma once

#include <optional>

#include "contour/cell_apex.h"
#include "contour/crossings.h"
#include "contour/sought.h"

namespace cdfr {

/// Where the tangents at both ends meet in the plane of the face, strictly inside the face, if the contour
/// has a corner there and not just a bend: at a corner the distance is right. On a round part the tangents'
/// meeting point stands out from the chord twice as far as the contour does, hence its distance is off by
/// half of that. `axis` is the face's; it is one of the cube.
std::optional<Vec3> face_bend(const Sought& sought, const PlainCube& cube, int axis, const Crossing& from,
                              const Crossing& to, SurfaceTally& tally);

}  // namespace cdfr
