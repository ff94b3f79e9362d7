#include "geometry/point_triangle.h"

#include <cmath>

#include "geometry/offset.h"
#include "geometry/orientation.h"
#include "geometry/planar_orientation.h"
#include "geometry/query_range.h"
#include "geometry/unit_normal.h"
#include "geometry/vertex_order.h"

namespace cdfr {
namespace {

double sum_of_magnitudes(const Vec3& v) noexcept { return std::fabs(v.x) + std::fabs(v.y) + std::fabs(v.z); }

/// Share of |p - v|_1 below which a height or an edge distance may be rounding alone: above the 2^-96 R of
/// the header.
constexpr double negligible = 0x1p-94;

Foot on_vertex(const Vec3& p, const Vec3& v, int corner) noexcept {
  Foot foot;
  foot.offset = difference(p, v);
  foot.squared = dot(foot.offset, foot.offset);
  foot.place = static_cast<TrianglePlace>(4 + corner);
  return foot;
}

/// Edge k in the direction from its vertex that comes first by coordinates, and how that runs against the
/// triangle: both turn round with the triangle, so what is computed from them does not.
struct CanonicalEdge {
  const Vec3& from;
  const Vec3& to;
  double sign;
};

CanonicalEdge canonical_edge(const TriangleShape& triangle, int k) noexcept {
  const Vec3& a = triangle.vertices[k];
  const Vec3& b = triangle.vertices[(k + 1) % 3];
  if (precedes(b, a)) return {b, a, -1};
  return {a, b, 1};
}

/// Distance to edge k in a canonical direction, so that both its triangles do the same arithmetic.
Foot on_edge(const Vec3& p, const TriangleShape& triangle, int k) noexcept {
  const auto [a, b, sign] = canonical_edge(triangle, k);
  const bool reversed = sign < 0;
  const int from = reversed ? (k + 1) % 3 : k;
  const int to = reversed ? k : (k + 1) % 3;
  const DoubleDouble3 r = difference(p, a);
  const DoubleDouble3 e = difference(b, a);
  const DoubleDouble s = dot(r, e);
  const DoubleDouble length = dot(e, e);
  if (!(DoubleDouble{} < s)) return on_vertex(p, a, from);
  if (!(s < length)) return on_vertex(p, b, to);
  const DoubleDouble t = s / length;
  Foot foot;
  for (int i = 0; i < 3; ++i) foot.offset[i] = r[i] - e[i] * t;
  foot.squared = dot(foot.offset, foot.offset);
  const double doubt = negligible * sum_of_magnitudes(rounded(r));
  if (foot.squared.hi <= doubt * doubt && collinear(a, b, p)) {
    foot.offset = {};
    foot.squared = {};
  }
  foot.along = reversed ? DoubleDouble{1, 0} - t : t;
  foot.place = static_cast<TrianglePlace>(1 + k);
  return foot;
}

/// Twice the signed area that p's projection spans with edge k, by the unit normal: positive inside.
DoubleDouble area_beside(const Vec3& p, const TriangleShape& triangle, int k) noexcept {
  const CanonicalEdge edge = canonical_edge(triangle, k);
  const DoubleDouble area =
      dot(cross(difference(edge.to, edge.from), difference(p, edge.from)), triangle.normal);
  return area * edge.sign;
}

struct Estimate {
  double value, bound;
};

/// area_beside in double. Products carry two differences and one multiplication, the cross product one
/// subtraction, the dot product one multiplication, the normal's rounding and two sums: 8u of |e|_1 |r|_1;
/// 16u covers second order.
Estimate estimated_area_beside(const Vec3& p, const TriangleShape& triangle, int k) noexcept {
  const CanonicalEdge edge = canonical_edge(triangle, k);
  const Vec3 e = minus(edge.to, edge.from);
  const Vec3 r = minus(p, edge.from);
  const double area = (e.y * r.z - e.z * r.y) * triangle.normal[0].hi +
                      (e.z * r.x - e.x * r.z) * triangle.normal[1].hi +
                      (e.x * r.y - e.y * r.x) * triangle.normal[2].hi;
  return {area * edge.sign, 16 * unit_roundoff * sum_of_magnitudes(e) * sum_of_magnitudes(r)};
}

/// True only if the projection is certainly inside edge k: the area exceeds 2^-96 |e|_1 |r|_1. Its own error
/// is below a third of that: 2^-98 from the normal, 40u^2 from cross and dot product. As a length it is below
/// 3 * 2^-96 R.
bool surely_beside(const Vec3& p, const TriangleShape& triangle, int k) noexcept {
  const CanonicalEdge edge = canonical_edge(triangle, k);
  const double size = sum_of_magnitudes(minus(edge.to, edge.from)) * sum_of_magnitudes(minus(p, edge.from));
  return area_beside(p, triangle, k).hi > 0x1p-96 * size;
}

bool projects_inside(const Vec3& p, const TriangleShape& triangle) noexcept {
  if (rounded(triangle.normal) == Vec3{}) return false;
  bool doubtful[3];
  for (int k = 0; k < 3; ++k) {
    const Estimate area = estimated_area_beside(p, triangle, k);
    if (area.value < -area.bound) return false;
    doubtful[k] = area.value <= area.bound;
  }
  for (int k = 0; k < 3; ++k) {
    if (doubtful[k] && !surely_beside(p, triangle, k)) return false;
  }
  return true;
}

/// Height above the plane, from the vertex that comes first by coordinates.
Foot on_face(const Vec3& p, const TriangleShape& triangle) noexcept {
  const auto& v = triangle.vertices;
  const Vec3* base = &v[0];
  if (precedes(v[1], *base)) base = &v[1];
  if (precedes(v[2], *base)) base = &v[2];
  const DoubleDouble3 r = difference(p, *base);
  DoubleDouble height = dot(r, triangle.normal);
  const double doubt = negligible * sum_of_magnitudes(rounded(r));
  if (std::fabs(height.hi) <= doubt) {
    const int side = orientation(v[0], v[1], v[2], p);
    height = {side * std::fmax(std::fabs(height.hi), doubt / 2), 0};
  }
  Foot foot;
  foot.along = height;
  foot.squared = height * height;
  foot.offset = scaled(triangle.normal, height);
  return foot;
}

/// Distance to edge k in double: off by less than 26u R (the clamped parameter moves the foot by at most 17u
/// R along the edge, differences, products and the root add 9u R); the bound is stated with |r|_1 + |e|_1 >=
/// R.
Estimate estimated_edge_distance(const Vec3& p, const TriangleShape& triangle, int k) noexcept {
  const CanonicalEdge edge = canonical_edge(triangle, k);
  const Vec3 e = minus(edge.to, edge.from);
  const Vec3 r = minus(p, edge.from);
  const double length = e.x * e.x + e.y * e.y + e.z * e.z;
  const double s = r.x * e.x + r.y * e.y + r.z * e.z;
  const double t = s > 0 ? (s < length ? s / length : 1) : 0;
  const Vec3 o{r.x - t * e.x, r.y - t * e.y, r.z - t * e.z};
  return {std::sqrt(o.x * o.x + o.y * o.y + o.z * o.z),
          64 * unit_roundoff * (sum_of_magnitudes(e) + sum_of_magnitudes(r))};
}

Foot on_boundary(const Vec3& p, const TriangleShape& triangle) noexcept {
  Estimate estimates[3];
  double least = HUGE_VAL;
  for (int k = 0; k < 3; ++k) {
    estimates[k] = estimated_edge_distance(p, triangle, k);
    least = std::fmin(least, estimates[k].value + estimates[k].bound);
  }
  Foot best;
  bool found = false;
  for (int k = 0; k < 3; ++k) {
    if (estimates[k].value - estimates[k].bound > least) continue;
    const Foot foot = on_edge(p, triangle, k);
    if (!found || foot.squared < best.squared) best = foot;
    found = true;
  }
  return best;
}

/// Exactly, for a triangle that has an area.
bool lies_on(const Vec3& p, const TriangleShape& triangle) noexcept {
  const auto& v = triangle.vertices;
  if (orientation(v[0], v[1], v[2], p) != 0) return false;
  const Vec3 n = rounded(triangle.normal);
  const double size[3] = {std::fabs(n.x), std::fabs(n.y), std::fabs(n.z)};
  const int axis = size[0] >= size[1] ? (size[0] >= size[2] ? 0 : 2) : (size[1] >= size[2] ? 1 : 2);
  int positive = 0, negative = 0;
  for (int k = 0; k < 3; ++k) {
    const int side =
        planar_orientation(seen_along(axis, v[k]), seen_along(axis, v[(k + 1) % 3]), seen_along(axis, p));
    positive += side > 0;
    negative += side < 0;
  }
  return positive == 0 || negative == 0;
}

}  // namespace

Foot measure(const Vec3& p, const TriangleShape& triangle) noexcept {
  if (projects_inside(p, triangle)) return on_face(p, triangle);
  Foot foot = on_boundary(p, triangle);
  // A face's border belongs to the edges as far as projections are doubtful: 2^-94 R.
  const auto& v = triangle.vertices;
  const double doubt = 0x1p-90 * (sum_of_magnitudes(minus(p, v[0])) + sum_of_magnitudes(minus(v[1], v[0])) +
                                  sum_of_magnitudes(minus(v[2], v[0])));
  const bool has_area = rounded(triangle.normal) != Vec3{};
  if (foot.squared.hi > 0 && foot.squared.hi <= doubt * doubt && has_area && lies_on(p, triangle)) {
    foot.offset = {};
    foot.squared = {};
  }
  return foot;
}

std::array<double, 3> barycentric(const Vec3& p, const TriangleShape& triangle, const Foot& foot) noexcept {
  std::array<double, 3> weights{};
  if (foot.place >= 4) {
    weights[foot.place - 4] = 1;
  } else if (foot.place >= 1) {
    const int k = foot.place - 1;
    weights[k] = (DoubleDouble{1, 0} - foot.along).hi;
    weights[(k + 1) % 3] = foot.along.hi;
  } else {
    DoubleDouble areas[3];
    for (int k = 0; k < 3; ++k) areas[(k + 2) % 3] = area_beside(p, triangle, k);
    const DoubleDouble total = areas[0] + areas[1] + areas[2];
    for (int k = 0; k < 3; ++k) weights[k] = (areas[k] / total).hi;
  }
  return weights;
}

}  // namespace cdfr
