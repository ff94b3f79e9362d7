#include "geometry/triangle_contact.h"

#include <cmath>
#include <utility>

#include "geometry/double_double.h"
#include "geometry/orientation.h"
#include "geometry/planar_orientation.h"
#include "geometry/unit_normal.h"

namespace cdfr {
namespace {

using Corners = std::array<Vec3, 3>;
using Outline = std::array<PlanarPoint, 3>;
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

Outline seen_along(int axis, const Corners& t) noexcept {
  return {seen_along(axis, t[0]), seen_along(axis, t[1]), seen_along(axis, t[2])};
}

int turn(const Outline& t) noexcept { return planar_orientation(t[0], t[1], t[2]); }

/// An axis along which the projection has an area, else any: then the triangle has none.
int projection_axis(const Corners& t) noexcept {
  const int broad = broad_axis(t);
  for (const int axis : {broad, (broad + 1) % 3, (broad + 2) % 3}) {
    if (turn(seen_along(axis, t)) != 0) return axis;
  }
  return broad;
}

Signs sides_of(const Corners& plane, const Corners& points) noexcept {
  return {orientation(plane[0], plane[1], plane[2], points[0]),
          orientation(plane[0], plane[1], plane[2], points[1]),
          orientation(plane[0], plane[1], plane[2], points[2])};
}

bool strictly_on_one_side(const Signs& s) noexcept { return s[0] != 0 && s[0] == s[1] && s[1] == s[2]; }

/// The line p q has `own`, the rest of one triangle, on one side or on it, and the others strictly on the
/// other side.
bool line_separates(const PlanarPoint& p, const PlanarPoint& q, const PlanarPoint& own,
                    const Outline& others) noexcept {
  const int side = planar_orientation(p, q, others[0]);
  return side != 0 && planar_orientation(p, q, others[1]) == side &&
         planar_orientation(p, q, others[2]) == side && planar_orientation(p, q, own) != side;
}

bool an_edge_separates(const Outline& a, const Outline& b) noexcept {
  for (int k = 0; k < 3; ++k) {
    if (line_separates(a[k], a[(k + 1) % 3], a[(k + 2) % 3], b)) return true;
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
bool planar_segment_meets(const PlanarPoint& p, const PlanarPoint& q, const Outline& t) noexcept {
  if (line_separates(p, q, p, t)) return false;
  const int outside = -turn(t);
  for (int k = 0; k < 3; ++k) {
    const PlanarPoint &from = t[k], &to = t[(k + 1) % 3];
    if (planar_orientation(from, to, p) == outside && planar_orientation(from, to, q) == outside)
      return false;
  }
  return true;
}

bool segment_meets(const Vec3& p, const Vec3& q, int side_of_p, int side_of_q, const Corners& t) noexcept {
  if (side_of_p == 0 && side_of_q == 0) {
    const int axis = projection_axis(t);
    return planar_segment_meets(seen_along(axis, p), seen_along(axis, q), seen_along(axis, t));
  }
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
  const Outline a_seen = seen_along(axis, a), b_seen = seen_along(axis, b);
  if (an_edge_separates(a_seen, b_seen) || an_edge_separates(b_seen, a_seen)) return false;
  const Signs b_sides = sides_of(a, b);
  if (strictly_on_one_side(b_sides)) return false;
  if (b_sides == Signs{}) return true;
  const Signs a_sides = sides_of(b, a);
  if (strictly_on_one_side(a_sides)) return false;
  return an_edge_meets(b, b_sides, a) || an_edge_meets(a, a_sides, b);
}

/// True if from v the points p and q are seen in opposite directions of an axis.
bool opposite(const PlanarPoint& v, const PlanarPoint& p, const PlanarPoint& q) noexcept {
  const auto between = [](double at, double first, double second) {
    return (first < at && at < second) || (second < at && at < first);
  };
  return between(v.u, p.u, q.u) || between(v.v, p.v, q.v);
}

/// A corner as seen from the line of an edge of the other triangle.
struct Seen {
  const PlanarPoint& point;
  int side = 0;
};

/// The line through v and p has the rest of p's triangle on its side `own`. It separates the triangles but
/// for v if the other one is strictly on the other side, or reaches the line in an edge that leaves v in the
/// opposite direction: then what the triangles have over the line has only v in common.
bool ray_separates(const PlanarPoint& v, const PlanarPoint& p, int own, const Seen& first,
                   const Seen& second) noexcept {
  const int side = first.side + second.side;
  if (side == 0 || own * side > 0) return false;
  if (first.side == second.side) return true;
  return own != 0 && opposite(v, p, first.side == 0 ? first.point : second.point);
}

/// Do the projections of triangles with corner 0 in common meet there only? Complete if both have an area: a
/// line that separates the two angles at the corner turns until it reaches a side of one of them, and what it
/// then meets of the other is a side in the opposite direction, if anything.
bool angles_apart(const Outline& a, const Outline& b) noexcept {
  const PlanarPoint& v = a[0];
  std::array<std::array<int, 2>, 2> sides{};
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 2; ++j) sides[i][j] = planar_orientation(v, a[1 + i], b[1 + j]);
  }
  const int a_turn = turn(a);
  if (ray_separates(v, a[1], a_turn, {b[1], sides[0][0]}, {b[2], sides[0][1]}) ||
      ray_separates(v, a[2], -a_turn, {b[1], sides[1][0]}, {b[2], sides[1][1]})) {
    return true;
  }
  const int b_turn = turn(b);
  return ray_separates(v, b[1], b_turn, {a[1], -sides[0][0]}, {a[2], -sides[1][0]}) ||
         ray_separates(v, b[2], -b_turn, {a[1], -sides[0][1]}, {a[2], -sides[1][1]});
}

/// Corner 0 in common. A ray from it to another common point leaves each triangle through the edge opposite;
/// the nearer of these two points is on both triangles. So they meet in more than the corner only if the
/// opposite edge of one meets the other.
bool meet_beside_corner(const Corners& a, const Corners& b, int axis) noexcept {
  if (angles_apart(seen_along(axis, a), seen_along(axis, b))) return false;
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
  return turn(seen_along(axis, a)) == turn(seen_along(axis, b)) && orientation(a[0], a[1], a[2], b[2]) == 0;
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

bool have_common_vertex(const ContactTriangle& a, const ContactTriangle& b) noexcept {
  const auto is_of_b = [&](std::uint32_t v) {
    return v == b.vertices[0] || v == b.vertices[1] || v == b.vertices[2];
  };
  return is_of_b(a.vertices[0]) || is_of_b(a.vertices[1]) || is_of_b(a.vertices[2]);
}

/// Is all of the other triangle but common vertices strictly on one side of the plane? Then they meet nowhere
/// else. The normal is within u of the exact one in each component; differences, products and two sums
/// round by u each: less than 8u of the products' sizes together. Products below the least double are lost by
/// less than 2^-1000. False where that leaves it open.
bool plane_separates(const ContactTriangle& plane, const ContactTriangle& other) noexcept {
  const Vec3 &v = plane.corners[0], &n = plane.normal;
  const auto is_common = [&](std::uint32_t vertex) {
    return vertex == plane.vertices[0] || vertex == plane.vertices[1] || vertex == plane.vertices[2];
  };
  bool above = false, below = false;
  for (std::size_t k = 0; k < 3; ++k) {
    if (is_common(other.vertices[k])) continue;
    const Vec3& p = other.corners[k];
    const double x = (p.x - v.x) * n.x, y = (p.y - v.y) * n.y, z = (p.z - v.z) * n.z;
    const double height = x + y + z;
    const double error = (std::fabs(x) + std::fabs(y) + std::fabs(z)) * (8 * unit_roundoff) + 0x1p-1000;
    if (std::fabs(height) <= error) return false;
    (height > 0 ? above : below) = true;
  }
  return above != below;
}

bool meet_beside_common(ContactTriangle a, ContactTriangle b, int axis) noexcept {
  const int common = common_first(a, b);
  if (common == 1) return meet_beside_corner(a.corners, b.corners, axis);
  return common == 2 && meet_beside_edge(a.corners, b.corners, axis);
}

bool meet(const ContactTriangle& a, const ContactTriangle& b, int axis) noexcept {
  if (plane_separates(a, b) || plane_separates(b, a)) return false;
  if (have_common_vertex(a, b)) return meet_beside_common(a, b, axis);
  return meet_apart(a.corners, b.corners, axis);
}

}  // namespace

ContactProbe::ContactProbe(const ContactTriangle& triangle) noexcept
    : triangle_(triangle),
      axis_(projection_axis(triangle.corners)),
      has_area_(turn(seen_along(axis_, triangle.corners)) != 0) {}

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
