/// Small meshes with known distances, made in place.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

#include "cdfr/mesh/mesh.h"
#include "support/random.h"

namespace cdfr::test {

/// A closed box; outward normals.
inline Mesh box_mesh(const Box& b) {
  Mesh mesh;
  for (int i = 0; i < 8; ++i) {
    mesh.vertices.push_back({i & 1 ? b.hi.x : b.lo.x, i & 2 ? b.hi.y : b.lo.y, i & 4 ? b.hi.z : b.lo.z});
  }
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

/// Each triangle cut in four `times` times, all vertices on the sphere of that radius to an ulp.
/// Precondition: those of `mesh` are on the unit sphere.
inline Mesh divided_sphere(Mesh mesh, int times, double radius, Vec3 centre) {
  for (int t = 0; t < times; ++t) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const auto [at, is_new] = middles.try_emplace({std::min(a, b), std::max(a, b)},
                                                    static_cast<std::uint32_t>(mesh.vertices.size()));
      if (is_new) {
        const Vec3 p = mesh.vertices[a], q = mesh.vertices[b];
        const Vec3 m{p.x + q.x, p.y + q.y, p.z + q.z};
        const double length = std::sqrt(m.x * m.x + m.y * m.y + m.z * m.z);
        mesh.vertices.push_back({m.x / length, m.y / length, m.z / length});
      }
      return at->second;
    };
    std::vector<Triangle> finer;
    for (const Triangle& f : mesh.triangles) {
      const std::uint32_t ab = middle(f[0], f[1]), bc = middle(f[1], f[2]), ca = middle(f[2], f[0]);
      finer.insert(finer.end(), {{f[0], ab, ca}, {ab, f[1], bc}, {ca, bc, f[2]}, {ab, bc, ca}});
    }
    mesh.triangles = std::move(finer);
  }
  for (Vec3& v : mesh.vertices)
    v = {centre.x + v.x * radius, centre.y + v.y * radius, centre.z + v.z * radius};
  return mesh;
}

/// Of an octahedron: 8 * 4^times triangles.
inline Mesh sphere_mesh(int times, double radius = 1, Vec3 centre = {}) {
  Mesh mesh;
  mesh.vertices = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  mesh.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  return divided_sphere(std::move(mesh), times, radius, centre);
}

/// Of an icosahedron: 20 * 4^times triangles, all nearly equilateral.
inline Mesh icosphere(int times, double radius = 1, Vec3 centre = {}) {
  const double a = std::sqrt((5 - std::sqrt(5.0)) / 10), b = std::sqrt((5 + std::sqrt(5.0)) / 10);
  Mesh mesh;
  mesh.vertices = {{-a, b, 0},  {a, b, 0},  {-a, -b, 0}, {a, -b, 0}, {0, -a, b},  {0, a, b},
                   {0, -a, -b}, {0, a, -b}, {b, 0, -a},  {b, 0, a},  {-b, 0, -a}, {-b, 0, a}};
  mesh.triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                    {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                    {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  return divided_sphere(std::move(mesh), times, radius, centre);
}

/// Triangles with corners anywhere in the box: open, crossing, of all shapes.
inline Mesh soup(std::size_t count, const Box& box, std::uint64_t seed) {
  Random random(seed);
  Mesh mesh;
  for (std::uint32_t i = 0; i < count; ++i) {
    for (int k = 0; k < 3; ++k) mesh.vertices.push_back(random.in(box));
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return mesh;
}

}  // namespace cdfr::test
