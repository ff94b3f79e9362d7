/// The winding number by its definition, in long double: every triangle's solid angle, no tree.
#pragma once

#include <array>
#include <cmath>

#include "cdfr/mesh/mesh.h"

namespace cdfr::test {

/// Off where p is within about 1e-15 of the mesh's size of the surface.
inline double brute_winding(MeshView mesh, const Vec3& p) {
  using Real = long double;
  using Vector = std::array<Real, 3>;
  const auto from = [&](const Vec3& v) {
    return Vector{Real{v.x} - Real{p.x}, Real{v.y} - Real{p.y}, Real{v.z} - Real{p.z}};
  };
  const auto dot = [](const Vector& u, const Vector& v) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; };
  Real sum = 0;
  for (const Triangle& t : mesh.triangles) {
    const Vector a = from(mesh.vertices[t[0]]), b = from(mesh.vertices[t[1]]), c = from(mesh.vertices[t[2]]);
    const Real la = std::sqrt(dot(a, a)), lb = std::sqrt(dot(b, b)), lc = std::sqrt(dot(c, c));
    const Vector n{b[1] * c[2] - b[2] * c[1], b[2] * c[0] - b[0] * c[2], b[0] * c[1] - b[1] * c[0]};
    sum += std::atan2(dot(a, n), la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
  }
  return static_cast<double>(sum / (2 * 3.14159265358979323846264338327950288L));
}

}  // namespace cdfr::test
