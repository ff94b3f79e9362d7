/// What two triangles have in common, in rational numbers: one is clipped by the plane and the edges of the
/// other.
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "cdfr/core/types.h"
#include "geometry/triangle_contact.h"

namespace cdfr::test {

using Rational3 = std::array<mpq_class, 3>;
using Polygon = std::vector<Rational3>;

inline Rational3 exact(const Vec3& p) { return {mpq_class(p.x), mpq_class(p.y), mpq_class(p.z)}; }

inline Rational3 minus(const Rational3& a, const Rational3& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Rational3 cross(const Rational3& a, const Rational3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline mpq_class dot(const Rational3& a, const Rational3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline bool is_zero(const Rational3& a) { return a[0] == 0 && a[1] == 0 && a[2] == 0; }

/// The part of a convex polygon, segment or point where (p - origin) . normal >= 0.
inline Polygon clipped(const Polygon& polygon, const Rational3& origin, const Rational3& normal) {
  Polygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Rational3 &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const mpq_class at_p = dot(minus(p, origin), normal), at_q = dot(minus(q, origin), normal);
    if (at_p >= 0) kept.push_back(p);
    if (sgn(at_p) * sgn(at_q) >= 0) continue;
    const mpq_class share = at_p / (at_p - at_q);
    Rational3 crossing = minus(q, p);
    for (std::size_t k = 0; k < 3; ++k) crossing[k] = p[k] + share * crossing[k];
    kept.push_back(crossing);
  }
  return kept;
}

/// Points whose convex hull is what the closed triangles have in common. Precondition: b has an area.
inline Polygon common_points(const std::array<Vec3, 3>& a, const std::array<Vec3, 3>& b) {
  const std::array<Rational3, 3> t{exact(b[0]), exact(b[1]), exact(b[2])};
  const Rational3 up = cross(minus(t[1], t[0]), minus(t[2], t[0]));
  const Rational3 down{-up[0], -up[1], -up[2]};
  Polygon common = clipped({exact(a[0]), exact(a[1]), exact(a[2])}, t[0], up);
  common = clipped(common, t[0], down);
  for (std::size_t k = 0; k < 3; ++k) common = clipped(common, t[k], cross(up, minus(t[(k + 1) % 3], t[k])));
  return common;
}

inline bool has_no_area(const std::array<Vec3, 3>& t) {
  return is_zero(cross(minus(exact(t[1]), exact(t[0])), minus(exact(t[2]), exact(t[0]))));
}

/// Is there a common point outside the hull of the common vertices? By definition, with no short cut.
inline bool meet_exactly(const ContactTriangle& a, const ContactTriangle& b) {
  if (has_no_area(a.corners) || has_no_area(b.corners)) return false;
  std::vector<Rational3> shared;
  for (std::size_t i = 0; i < 3; ++i) {
    if (std::find(b.vertices.begin(), b.vertices.end(), a.vertices[i]) != b.vertices.end())
      shared.push_back(exact(a.corners[i]));
  }
  if (shared.size() == 3) return false;
  const Polygon common = common_points(a.corners, b.corners);
  return std::any_of(common.begin(), common.end(), [&](const Rational3& p) {
    if (shared.empty()) return true;
    const Rational3 from = minus(p, shared.front());
    if (shared.size() == 1) return !is_zero(from);
    const Rational3 edge = minus(shared.back(), shared.front());
    // What is on both triangles and on the line of their edge is on the edge.
    return !is_zero(cross(edge, from));
  });
}

}  // namespace cdfr::test
