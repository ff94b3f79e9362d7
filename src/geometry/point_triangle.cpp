#include "geometry/point_triangle.h"

#include <cmath>

#include "geometry/certain_foot.h"
#include "geometry/offset.h"
#include "geometry/orientation.h"
#include "geometry/planar_orientation.h"
#include "geometry/query_range.h"
#include "geometry/unit_normal.h"
#include "geometry/vertex_order.h"

namespace cdfr {
namespace {

double sum_of_magnitudes(const Vec3& v) noexcept { return std::fabs(v.x) + std::fabs(v.y) + std::fabs(v.z); }

Foot on_vertex(const Vec3& p, const Vec3& v, int corner) noexcept {
  Foot foot;
  foot.offset = difference(p, v);
  foot.squared = dot(foot.offset, foot.offset);
  foot.place = static_cast<TrianglePlace>(4 + corner);
  return foot;
}

/// Edge k in the direction from its corner that comes first by coordinates: turns round with the triangle, so
/// what is computed from it does not.
struct CanonicalEdge {
  int from, to;
  bool reversed;  ///< against the triangle's own direction
};

CanonicalEdge canonical_edge(const TriangleShape& triangle, int k) noexcept {
  const int next = k < 2 ? k + 1 : 0;
  if (precedes(triangle.vertices[next], triangle.vertices[k])) return {next, k, true};
  return {k, next, false};
}

/// Distance to edge k in a canonical direction, so that both its triangles do the same arithmetic.
Foot on_edge(const Vec3& p, const TriangleShape& triangle, int k) noexcept {
  const auto [from, to, reversed] = canonical_edge(triangle, k);
  const Vec3& a = triangle.vertices[from];
  const Vec3& b = triangle.vertices[to];
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
  const double doubt = negligible_height * sum_of_magnitudes(rounded(r));
  if (foot.squared.hi <= doubt * doubt && collinear(a, b, p)) {
    foot.offset = {};
    foot.squared = {};
  }
  foot.along = t;
  foot.place = static_cast<TrianglePlace>(1 + k);
  return foot;
}

/// Twice the signed area that p's projection spans with edge k, by the unit normal: positive inside.
DoubleDouble area_beside(const Vec3& p, const TriangleShape& triangle, int k) noexcept {
  const auto [from, to, reversed] = canonical_edge(triangle, k);
  const Vec3& a = triangle.vertices[from];
  const DoubleDouble area =
      dot(cross(difference(triangle.vertices[to], a), difference(p, a)), triangle.normal);
  return area * (reversed ? -1.0 : 1.0);
}

/// True only if the projection is certainly inside edge k: the area exceeds 2^-96 |e|_1 |r|_1. Its own error
/// is below a third of that: 2^-98 from the normal, 40u^2 from cross and dot product. As a length it is below
/// 3 * 2^-96 R.
bool surely_beside(const Vec3& p, const TriangleShape& triangle, int k) noexcept {
  const auto [from, to, reversed] = canonical_edge(triangle, k);
  const Vec3& a = triangle.vertices[from];
  const double size = sum_of_magnitudes(minus(triangle.vertices[to], a)) * sum_of_magnitudes(minus(p, a));
  return area_beside(p, triangle, k).hi > 0x1p-96 * size;
}

bool projects_inside(const Vec3& p, const TriangleShape& triangle, const PlaceEstimate& estimate) noexcept {
  if (estimate.outside) return false;
  for (int k = 0; k < 3; ++k) {
    if (!estimate.beside[k] && !surely_beside(p, triangle, k)) return false;
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
  const double doubt = negligible_height * sum_of_magnitudes(rounded(r));
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

Foot on_boundary(const Vec3& p, const TriangleShape& triangle, const PlaceEstimate& estimate) noexcept {
  Foot best;
  bool found = false;
  for (int k = 0; k < 3; ++k) {
    if (!estimate.may_be_least[k]) continue;
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

/// Where double precision leaves the place open.
Foot decided(const Vec3& p, const TriangleShape& triangle, const PlaceEstimate& estimate) noexcept {
  if (projects_inside(p, triangle, estimate)) return on_face(p, triangle);
  Foot foot = on_boundary(p, triangle, estimate);
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

}  // namespace

Foot measure(const Vec3& p, const TriangleShape& triangle, const PlaceEstimate& estimate) noexcept {
  const TrianglePlace place = estimate.place;
  Foot foot;
  if (place != unsure_place && measure_certain(place, p, triangle, foot)) return foot;
  if (place == 0) return on_face(p, triangle);
  if (place == unsure_place) return decided(p, triangle, estimate);
  if (place < 4) return on_edge(p, triangle, place - 1);
  return on_vertex(p, triangle.vertices[place - 4], place - 4);
}

Foot measure(const Vec3& p, const TriangleShape& triangle) noexcept {
  return measure(p, triangle, estimate_place(p, triangle));
}

std::array<double, 3> barycentric(const Vec3& p, const TriangleShape& triangle, const Foot& foot) noexcept {
  std::array<double, 3> weights{};
  if (foot.place >= 4) {
    weights[foot.place - 4] = 1;
  } else if (foot.place >= 1) {
    const int k = foot.place - 1;
    const DoubleDouble rest = DoubleDouble{1, 0} - foot.along;
    const DoubleDouble along = canonical_edge(triangle, k).reversed ? rest : foot.along;
    weights[k] = (DoubleDouble{1, 0} - along).hi;
    weights[(k + 1) % 3] = along.hi;
  } else {
    DoubleDouble areas[3];
    for (int k = 0; k < 3; ++k) areas[(k + 2) % 3] = area_beside(p, triangle, k);
    const DoubleDouble total = areas[0] + areas[1] + areas[2];
    for (int k = 0; k < 3; ++k) weights[k] = (areas[k] / total).hi;
  }
  return weights;
}

}  // namespace cdfr
