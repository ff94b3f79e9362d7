/// Triangles and splats to samples. Nearest wins, the first drawn among equals.
#pragma once

#include <span>

#include "cdfr/core/sinks.h"
#include "cdfr/mesh/mesh.h"
#include "render/band.h"
#include "render/view.h"

namespace cdfr {

/// The part into `front` and `back`. Preconditions: indices are in range, coordinates within 2^200.
void draw_part(MeshView part, const View& view, Band& band);

/// Each point as a disc in its tangent plane, into `points`. The radius is in samples.
void draw_points(std::span<const ContourPoint> points, const View& view, double radius, Layer& layer);

}  // namespace cdfr
