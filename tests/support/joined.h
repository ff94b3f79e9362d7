/// Meshes put together.
#pragma once

#include <cstdint>
#include <utility>

#include "cdfr/mesh/mesh.h"

namespace cdfr::test {

/// The triangles of both, those of `b` after those of `a`.
inline Mesh joined(Mesh a, const Mesh& b) {
  const auto first = static_cast<std::uint32_t>(a.vertices.size());
  a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
  for (const Triangle& t : b.triangles) a.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  return a;
}

inline Mesh moved(Mesh mesh, const Vec3& by) {
  for (Vec3& v : mesh.vertices) v = {v.x + by.x, v.y + by.y, v.z + by.z};
  return mesh;
}

}  // namespace cdfr::test
