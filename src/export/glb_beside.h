/// What a GLB shows beside the part: balls, a legend, labels.
#pragma once

#include "export/frame.h"
#include "export/glb_scene.h"

namespace cdfr {

/// One ball of triangles, drawn at each place in its size.
void add_balls(const PaintedMesh& painted, const Frame& frame, GlbScene& scene);

/// The ramp as an upright bar on the part's right, with five values, and with grey below if a value is
/// missing. Nothing if no array is painted. `ink` is the material of text.
void add_legend(const PaintedMesh& painted, const Frame& frame, int ink, GlbScene& scene);

/// Lines of text on the part's left, the one of the highest place on top, each with a thin line to its place.
void add_labels(const PaintedMesh& painted, const Frame& frame, int ink, GlbScene& scene);

}  // namespace cdfr
