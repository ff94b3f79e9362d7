/// Do triangles cover a cell's silhouette, seen along a direction?
#pragma once

#include <Eigen/Core>

#include <vector>

#include "field/near_triangles.h"
#include "field/field_data.h"

namespace cdfr {

/// The plane is that of the points y with gradient.(y - centre) = -value, the feet of a linear distance. True
/// if the pieces of triangles that lie within `slack` of it cover the cell's silhouette along the gradient:
/// every point of the cell then has a surface point within |its distance from the plane| + slack.
///
/// The shadow of a cube of edge a along a unit vector g is the hexagon |((y - c) x g)_k| <= a/2 (|g_i| +
/// |g_j|) for the three k, {i, j, k} = {0, 1, 2}. Triangles are clipped to it (Sutherland, Hodgman 1974);
/// pieces with a vertex farther from the plane count for nothing. The areas of the rest, signed by the side
/// they turn to the cell, add up to the hexagon's if they cover it: on an oriented surface that does not meet
/// itself, sheets one behind another turn alternate sides, so that a hole is not made up for by a double
/// cover elsewhere, unless two sheets were as close as the slack. On other input checks on the finished mesh
/// catch what this lets pass.
bool covers(const FieldData& field, const Eigen::Vector3d& centre, double size,
            const Eigen::Vector3d& gradient, double value, double slack,
            const std::vector<NearTriangle>& near);

}  // namespace cdfr
