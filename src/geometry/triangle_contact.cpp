#include "geometry/triangle_contact.h"

#include <cmath>
#include <utility>

#include "geometry/orientation.h"
#include "geometry/planar_orientation.h"
#include "geometry/unit_normal.h"

namespace cdfr {
namespace {

using Corners = std::array<Vec3, 3>;
using Signs = std::array<int, 3>;

/// The axis along which the triangle looks largest; its projection may have no area only if rounding misled.
int broad_axis(const Corners& t) noexcept {
  const double ex = t[1].x - t[0].x, ey = t[1].y - t[0].y, ez = t[1].z - t[0].z;
  const double fx = t[2].x - t[0].x, fy = t[2].y - t[0].y, fz = t[2].z - t[0].z;
  const double x = std::fabs(ey * fz - ez * fy);
  const double y = std::fabs(ez * fx - ex * fz);
  const double z = std::fabs(ex * fy - ey * fx);
  if (x > y) return x > z ? 0 : 2;
  return y > z ? 1 : 2;
}

int turn(const Corners& t, int axis) noexcept { return planar_orientation(t[0], t[1], t[2], axis); }

/// An axis along which the projection has an area, else any: then the triangle has none.
int projection_axis(const Corners& t) noexcept {
  const int broad = broad_axis(t);
  for (const int axis : {broad, (broad + 1) % 3, (broad + 2) % 3}) {
    if (turn(t, axis) != 0) return axis;
  }
  return broad;
}

Signs sides_of(const Corners& plane, const Corners& points) noexcept {
  return {orientation(plane[0], plane[1], plane[2], points[0]),
          orientation(plane[0], plane[1], plane[2], points[1]),
          orientation(plane[0], plane[1], plane[2], points[2])};
}

bool strictly_on_one_side(const Signs& s) noexcept { return s[0] != 0 && s[0] == s[1] && s[1] == s[2]; }

/// Seen along the axis, the line p q has one triangle on one side, or on it, and the other strictly on the
/// other.
bool line_separates(const Vec3& p, const Vec3& q, const Vec3& own, const Corners& others, int axis) noexcept {
  const int side = planar_orientation(p, q, others[0], axis);
  return side != 0 && planar_orientation(p, q, others[1], axis) == side &&
         planar_orientation(p, q, others[2], axis) == side && planar_orientation(p, q, own, axis) != side;
}

bool an_edge_separates(const Corners& a, const Corners& b, int axis) noexcept {
  for (int k = 0; k < 3; ++k) {
    if (line_separates(a[k], a[(k + 1) % 3], a[(k + 2) % 3], b, axis)) return true;
  }
  return false;
}

/// A segment that has the ends' sides of the triangle's plane, not both 0, meets the plane in at most one
/// point x. From any point of the segment's line off the plane x is seen inside the closed triangle if it is
/// not on different sides of two edges.
bool crossing_segment_meets(const Vec3& p, const Vec3& q, int side_of_p, int side_of_q,
                            const Corners& t) noexcept {
  if (side_of_p * side_of_q > 0) return false;
  bool positive = false, negative = false;
  for (int k = 0; k < 3; ++k) {
    const int side = orientation(p, q, t[k], t[(k + 1) % 3]);
    positive = positive || side > 0;
    negative = negative || side < 0;
  }
  return !(positive && negative);
}

/// Convex sets in a plane that are apart are separated by the line of a side of one of them, for one of those
/// lines bounds their Minkowski difference towards the origin; the difference with a segment has sides along
/// the triangle's and the segment's only.
bool planar_segment_meets(const Vec3& p, const Vec3& q, const Corners& t, int axis) noexcept {
  if (line_separates(p, q, p, t, axis)) return false;
  const int inside = turn(t, axis);
  for (int k = 0; k < 3; ++k) {
    const Vec3 &from = t[k], &to = t[(k + 1) % 3];
    if (planar_orientation(from, to, p, axis) == -inside && planar_orientation(from, to, q, axis) == -inside)
      return false;
  }
  return true;
}

bool segment_meets(const Vec3& p, const Vec3& q, int side_of_p, int side_of_q, const Corners& t) noexcept {
  if (side_of_p == 0 && side_of_q == 0) return planar_segment_meets(p, q, t, projection_axis(t));
  return crossing_segment_meets(p, q, side_of_p, side_of_q, t);
}

bool an_edge_meets(const Corners& edges, const Signs& sides, const Corners& t) noexcept {
  for (int k = 0; k < 3; ++k) {
    const int next = (k + 1) % 3;
    if (segment_meets(edges[k], edges[next], sides[k], sides[next], t)) return true;
  }
  return false;
}

/// No vertex in common. The projection along an axis that leaves `a` its area settles what is apart there,
/// and all of it for triangles in one plane: the projections of those are apart only if the line of an edge
/// separates them (as above). Triangles in different planes meet in a segment or point of the line of both
/// planes; where it ends, an edge of one of them ends it, so an edge of one meets the other.
bool meet_apart(const Corners& a, const Corners& b, int axis) noexcept {
  if (an_edge_separates(a, b, axis) || an_edge_separates(b, a, axis)) return false;
  const Signs b_sides = sides_of(a, b);
  if (strictly_on_one_side(b_sides)) return false;
  if (b_sides == Signs{}) return true;
  const Signs a_sides = sides_of(b, a);
  if (strictly_on_one_side(a_sides)) return false;
  return an_edge_meets(b, b_sides, a) || an_edge_meets(a, a_sides, b);
}

/// True if from v the points p and q are seen in opposite directions of an axis.
bool opposite(const Vec3& v, const Vec3& p, const Vec3& q) noexcept {
  const auto along = [](double at, double first, double second) {
    return (first < at && at < second) || (second < at && at < first);
  };
  return along(v.x, p.x, q.x) || along(v.y, p.y, q.y) || along(v.z, p.z, q.z);
}

/// A point of a triangle as seen from the line of an edge of the other.
struct Seen {
  const Vec3& point;
  int side = 0;
};

/// The line through v and p in a projection has the rest of p's triangle on its side `own`. It separates the
/// triangles but for v if the other one is strictly on the other side, or reaches the line in an edge that
/// leaves v in the opposite direction: then the triangles' parts over the line have only v in common.
bool ray_separates(const Vec3& v, const Vec3& p, int own, const Seen& first, const Seen& second) noexcept {
  const int side = first.side + second.side;
  if (side == 0 || own * side > 0) return false;
  if (first.side == second.side) return true;
  return own != 0 && opposite(v, p, first.side == 0 ? first.point : second.point);
}

/// Do the projections of triangles with the corner v in common meet there only? Complete if both projections
/// have an area: a line that separates the two angles at v turns until it reaches a side of one of them, and
/// what it then meets of the other is a side in the opposite direction, if anything.
bool angles_apart(const Corners& a, const Corners& b, int axis) noexcept {
  const Vec3& v = a[0];
  std::array<std::array<int, 2>, 2> sides{};
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 2; ++j) sides[i][j] = planar_orientation(v, a[1 + i], b[1 + j], axis);
  }
  const int a_turn = turn(a, axis), b_turn = turn(b, axis);
  return ray_separates(v, a[1], a_turn, {b[1], sides[0][0]}, {b[2], sides[0][1]}) ||
         ray_separates(v, a[2], -a_turn, {b[1], sides[1][0]}, {b[2], sides[1][1]}) ||
         ray_separates(v, b[1], b_turn, {a[1], -sides[0][0]}, {a[2], -sides[1][0]}) ||
         ray_separates(v, b[2], -b_turn, {a[1], -sides[0][1]}, {a[2], -sides[1][1]});
}

/// Corner 0 in common. A ray from it to another common point leaves each triangle through the edge opposite;
/// the nearer of these two points is on both triangles. So they meet in more than the corner only if the
/// opposite edge of one meets the other.
bool meet_beside_corner(const Corners& a, const Corners& b, int axis) noexcept {
  if (angles_apart(a, b, axis)) return false;
  const int b1 = orientation(a[0], a[1], a[2], b[1]);
  const int b2 = orientation(a[0], a[1], a[2], b[2]);
  if (b1 == 0 && b2 == 0) return true;
  if (b1 * b2 > 0) return false;
  const int a1 = orientation(b[0], b[1], b[2], a[1]);
  const int a2 = orientation(b[0], b[1], b[2], a[2]);
  return crossing_segment_meets(b[1], b[2], b1, b2, a) || crossing_segment_meets(a[1], a[2], a1, a2, b);
}

/// Corners 0 and 1 in common. Different planes meet in the line of that edge alone. Apexes that are on
/// different sides of it in one projection are so in their plane.
bool meet_beside_edge(const Corners& a, const Corners& b, int axis) noexcept {
  return turn(a, axis) == turn(b, axis) && orientation(a[0], a[1], a[2], b[2]) == 0;
}

/// Puts the common vertices first, in one order. How many there are.
int common_first(ContactTriangle& a, ContactTriangle& b) noexcept {
  int common = 0;
  for (int i = 0; i < 3; ++i) {
    for (int j = common; j < 3; ++j) {
      if (a.vertices[i] != b.vertices[j]) continue;
      std::swap(a.vertices[i], a.vertices[common]);
      std::swap(a.corners[i], a.corners[common]);
      std::swap(b.vertices[j], b.vertices[common]);
      std::swap(b.corners[j], b.corners[common]);
      ++common;
      break;
    }
  }
  return common;
}

bool meet(ContactTriangle a, ContactTriangle b, int axis) noexcept {
  switch (common_first(a, b)) {
    case 0:
      return meet_apart(a.corners, b.corners, axis);
    case 1:
      return meet_beside_corner(a.corners, b.corners, axis);
    case 2:
      return meet_beside_edge(a.corners, b.corners, axis);
    default:
      return false;
  }
}

}  // namespace

ContactProbe::ContactProbe(const ContactTriangle& triangle) noexcept
    : triangle_(triangle),
      axis_(projection_axis(triangle.corners)),
      has_area_(turn(triangle.corners, axis_) != 0) {}

bool ContactProbe::meets(const ContactTriangle& other) const noexcept {
  // Whether the other has an area is asked last: contacts are rare.
  return has_area_ && meet(triangle_, other, axis_) &&
         !collinear(other.corners[0], other.corners[1], other.corners[2]);
}

bool segment_meets_triangle(const std::array<Vec3, 2>& segment,
                            const std::array<Vec3, 3>& triangle) noexcept {
  const auto& [p, q] = segment;
  const auto side = [&](const Vec3& v) { return orientation(triangle[0], triangle[1], triangle[2], v); };
  return segment_meets(p, q, side(p), side(q), triangle);
}

}  // namespace cdfr
