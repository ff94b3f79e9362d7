/// What the source paper's extraction takes on the leaves of an octree: every sub-voxel of every leaf that
/// the contour may pass, and every triangle of the leaf for each.
#pragma once

#include "cdfr/field/field.h"
#include "cdfr/mesh/mesh.h"

namespace cdfr::bench {

/// Seconds on one core. Some leaves are gone through in part, in plain double precision, and the rest is
/// reckoned from them: all of it would take hours.
double papers_way_seconds(const Field& field, const Mesh& mesh, double distance, double tolerance);

}  // namespace cdfr::bench
