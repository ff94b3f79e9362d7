#include "oracle/exact_distance.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace cdfr::oracle {
namespace {

/// The closest point is origin + along * (numerator / denominator); all in units of one lattice.
struct Foot {
  IntegerVector origin, along;
  Integer numerator, denominator;
  Integer squared;  ///< squared distance times squared_denominator
  Integer squared_denominator;
};

Foot at_vertex(const IntegerVector& p, const IntegerVector& v) {
  const IntegerVector d = p - v;
  return {v, {0, 0, 0}, 0, 1, dot(d, d), 1};
}

/// Closest point of the segment vw. A segment of no length is its end v, since then (p - v).e = 0.
Foot on_segment(const IntegerVector& p, const IntegerVector& v, const IntegerVector& w) {
  const IntegerVector e = w - v;
  const IntegerVector d = p - v;
  const Integer along = dot(d, e);
  const Integer length = dot(e, e);
  if (along <= 0) return at_vertex(p, v);
  if (along >= length) return at_vertex(p, w);
  const IntegerVector moment = cross(d, e);
  return {v, e, along, length, dot(moment, moment), length};
}

/// The foot of the perpendicular, if it lies in the closed triangle: for each edge e from v the point must
/// not be on the outer side of the plane through e along the normal n, so (e x (p - v)) . n must not be
/// negative. No point is projected for this: the component of p along n drops out of the sign by itself.
std::optional<Foot> on_face(const IntegerVector& p, const std::array<IntegerVector, 3>& v) {
  const IntegerVector n = cross(v[1] - v[0], v[2] - v[0]);
  const Integer area = dot(n, n);
  if (area == 0) return std::nullopt;
  for (std::size_t i = 0; i < 3; ++i) {
    if (dot(cross(v[(i + 1) % 3] - v[i], p - v[i]), n) < 0) return std::nullopt;
  }
  const Integer height = dot(n, p - v[0]);
  return Foot{p, n, -height, area, height * height, area};
}

bool nearer(const Foot& a, const Foot& b) {
  return a.squared * b.squared_denominator < b.squared * a.squared_denominator;
}

Foot on_border(const IntegerVector& p, const std::array<IntegerVector, 3>& v) {
  Foot best = on_segment(p, v[0], v[1]);
  for (std::size_t i = 1; i < 3; ++i) {
    Foot side = on_segment(p, v[i], v[(i + 1) % 3]);
    if (nearer(side, best)) best = std::move(side);
  }
  return best;
}

Ratio coordinate(const Foot& foot, const Integer& origin, const Integer& along, int exponent) {
  return {origin * foot.denominator + along * foot.numerator, foot.denominator, exponent};
}

}  // namespace

Exact exact_distance(Vec3 p, Vec3 a, Vec3 b, Vec3 c) {
  const std::array<Vec3, 4> points{p, a, b, c};
  const int exponent = common_exponent(points);
  const IntegerVector query = on_lattice(p, exponent);
  const std::array<IntegerVector, 3> v{on_lattice(a, exponent), on_lattice(b, exponent),
                                       on_lattice(c, exponent)};
  const std::optional<Foot> face = on_face(query, v);
  // If the perpendicular misses the triangle, the closest point lies on its border.
  const Foot best = face ? *face : on_border(query, v);
  return {{best.squared, best.squared_denominator, 2 * exponent},
          {coordinate(best, best.origin.x, best.along.x, exponent),
           coordinate(best, best.origin.y, best.along.y, exponent),
           coordinate(best, best.origin.z, best.along.z, exponent)}};
}

double Exact::error_in_ulps(double computed, Vec3 p, double mesh_max_abs) const {
  return difference(computed, distance(), ulp_exponent(std::max(largest_coordinate(p), mesh_max_abs)));
}

double Exact::foot_error_in_ulps(Vec3 computed, Vec3 p, double mesh_max_abs) const {
  const int unit = ulp_exponent(std::max(largest_coordinate(p), mesh_max_abs));
  return std::max({difference(computed.x, foot[0], unit), difference(computed.y, foot[1], unit),
                   difference(computed.z, foot[2], unit)});
}

bool exact_less(const Exact& a, const Exact& b) { return compare(a.squared, b.squared) < 0; }

ExactClosest exact_closest(MeshView mesh, Vec3 p, std::span<const std::uint32_t> candidates) {
  std::optional<ExactClosest> best;
  for (const std::uint32_t number : candidates) {
    const Triangle& t = mesh.triangles[number];
    Exact exact = exact_distance(p, mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]);
    const int order = best ? compare(exact.squared, best->exact.squared) : -1;
    if (order < 0 || (order == 0 && number < best->triangle)) best = ExactClosest{std::move(exact), number};
  }
  return std::move(*best);
}

}  // namespace cdfr::oracle
