/// How far the distance in a cell is from one linear function, or from the least of two or three.
///
/// Let c be the cell's centre, a its edge, and T the triangles that may win in it (near_triangles.h). The
/// distance d_T to one triangle is convex, so nowhere below its tangent at c, L_T(x) = d_T(c) + g_T.(x - c).
/// Take for L_1 the tangent of the closest T. A linear function has its least value over the cell at a
/// corner:
///     min (L_T - L_1) = d_T - d_1 - (a / 2) |g_T - g_1|_1,
/// and T is explained by L_1 if that is at least -eps: then d_T >= L_1 - eps in all of the cell. It is
/// explained too if all of T lies behind the plane of L_1's feet, up to eps: for y with g_1.(y - c) <= -d_1 +
/// eps,
///     |x - y| >= g_1.(x - y) >= L_1(x) - eps,
/// as it is with the neighbours of T_1 in a flat wall or a ridge. Of those not explained, the closest gives
/// L_2, then L_3. If nothing is left, d >= min L_i - eps in the cell.
///
/// From above, d <= L_i + eps if the triangle T_i of L_i alone stays that close at all corners (convex once
/// more), or if the sheet that T_i belongs to does: seen along g_i, the triangles that lie within eps of the
/// plane of L_i's feet cover the cell's silhouette (covering.h). The second serves walls of small or thin
/// triangles, the first the round parts about edges and vertices.
///
/// Papers: the test is of Ju, Losasso, Schaefer, Warren, "Dual contouring of Hermite data" (2002) in its
/// purpose, a cell that is collapsed if few planes explain it; there the planes are of samples, here of all
/// that may be closest, so that it proves.
#pragma once

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <vector>

#include "field/near_triangles.h"

namespace cdfr {

/// A linear function: `value` at the centre.
struct TangentPlane {
  double value = 0;
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
};

/// How far the distance may be below and above one plane, and to either side of several: where planes meet at
/// an acute angle an error moves their corner by a multiple of itself.
struct Slack {
  double below = 0, above = 0, sharp = 0;
};

struct Flatness {
  int planes = 0;  ///< 1 to 3, or 0 if no such few functions are within the slack
  std::array<TangentPlane, 3> plane;
  double least = 0;  ///< lower bound on the distance in the cell
  double most = 0;   ///< upper bound
};

/// `near` must include all triangles that may win; it is not empty.
Flatness flatness(const FieldData& field, const Eigen::Vector3d& centre, double size, const Slack& slack,
                  const std::vector<NearTriangle>& near);

/// The same where the surface enters the cell: is the signed distance within the slack of the linear function
/// that has `plane.value` and `plane.gradient` at the centre, those of the signed distance there?
///
/// Let s be that function; then the surface has to be one sheet about the plane s = 0. From above, the sheet
/// covers the cell's silhouette within eps of the plane, so d <= |s| + eps. From below each T has d_T >= s -
/// eps and d_T >= -s - eps: by its tangent, or because it lies below the plane, or above it, but for eps;
/// triangles of the sheet do both. So no surface is where |s| > eps, the sign is one on either side, and two
/// sheets of opposite sides closer than eps do not count as a cover.
bool is_sheet(const FieldData& field, const Eigen::Vector3d& centre, double size, const Slack& slack,
              const TangentPlane& plane, const std::vector<NearTriangle>& near);

/// Bounds alone: `least` by tangents, `most` by the largest value at corners of one triangle, or of the mean
/// of two.
Flatness distance_bounds(const FieldData& field, const Eigen::Vector3d& centre, double size,
                         const std::vector<NearTriangle>& near);

/// How far above `height` the least of the planes may reach inside edges and faces of the cell whose corners
/// are all below it: corners do not show such a wedge. 0 if there is none.
double hidden_above(const Flatness& flat, double size, double height) noexcept;

}  // namespace cdfr
