/// The distance to triangles with whole coordinates below 2^16, by the definition and in long double: normals
/// are exact there, however thin the triangle.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "cdfr/mesh/mesh.h"
#include "faults/star.h"

namespace cdfr::test {

inline long double plain_distance(const Vec3& p, const Vec3& from, const Vec3& to) {
  const Offset e = between(from, to), d = between(from, p);
  const long double square = dot(e, e);
  const long double t = square > 0 ? std::clamp(dot(d, e) / square, 0.0L, 1.0L) : 0.0L;
  const Offset r{d[0] - t * e[0], d[1] - t * e[1], d[2] - t * e[2]};
  return std::sqrt(dot(r, r));
}

inline long double plain_distance(const Vec3& p, const std::array<Vec3, 3>& v) {
  const Offset n = cross(between(v[0], v[1]), between(v[0], v[2]));
  const long double square = dot(n, n);
  bool over = square > 0;
  long double least = HUGE_VALL;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 &a = v[k], &b = v[(k + 1) % 3];
    over = over && dot(cross(n, between(a, b)), between(a, p)) >= 0;
    least = std::min(least, plain_distance(p, a, b));
  }
  return over ? std::fabs(dot(n, between(v[0], p))) / std::sqrt(square) : least;
}

inline long double plain_distance(const Vec3& p, const Mesh& mesh) {
  long double least = HUGE_VALL;
  for (const Triangle& t : mesh.triangles) {
    least =
        std::min(least, plain_distance(p, {mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]}));
  }
  return least;
}

}  // namespace cdfr::test
