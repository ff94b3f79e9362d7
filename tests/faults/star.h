/// Solids that are star-shaped about the origin, their vertices at whole places of at most 2^10: the side of
/// a point on the grid of 2^-20 is exact in long double.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "cdfr/mesh/mesh.h"
#include "support/meshes.h"
#include "support/random.h"

namespace cdfr::test {

using Offset = std::array<long double, 3>;

inline Offset between(const Vec3& from, const Vec3& to) {
  const auto part = [](double a, double b) {
    return static_cast<long double>(b) - static_cast<long double>(a);
  };
  return {part(from.x, to.x), part(from.y, to.y), part(from.z, to.z)};
}
inline Offset cross(const Offset& u, const Offset& v) {
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}
inline long double dot(const Offset& u, const Offset& v) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; }

static_assert(std::numeric_limits<long double>::digits >= 60, "the exact sides need a longer type here");

/// Above 0 if d is on the front of a, b, c.
inline long double orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return dot(cross(between(a, b), between(a, c)), between(a, d));
}

/// Every triangle shows its back to the origin.
inline bool is_star(const Mesh& mesh) {
  for (const Triangle& t : mesh.triangles) {
    if (!(orientation(mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]], {}) < 0)) return false;
  }
  return true;
}

/// -1 inside, 0 on the surface, 1 outside.
inline int exact_side(const Mesh& star, const Vec3& p) {
  const Vec3 o{};
  for (const Triangle& t : star.triangles) {
    const Vec3 a = star.vertices[t[0]], b = star.vertices[t[1]], c = star.vertices[t[2]];
    if (orientation(o, a, b, p) < 0 || orientation(o, b, c, p) < 0 || orientation(o, c, a, p) < 0) continue;
    const long double height = orientation(a, b, c, p);
    return height > 0 ? 1 : (height < 0 ? -1 : 0);
  }
  return -1;
}

/// Spikes, dents, ridges and saddles: the directions of a sphere's vertices, radii at random.
inline Mesh spiky_star(int times, std::uint64_t seed) {
  Mesh mesh = sphere_mesh(times);
  Random random(seed);
  for (Vec3& v : mesh.vertices) {
    const double radius = random.below(3) == 0 ? 1000 : random.between(150, 400);
    v = {std::nearbyint(v.x * radius), std::nearbyint(v.y * radius), std::nearbyint(v.z * radius)};
  }
  return mesh;
}

/// Two apexes of that valence over a ring whose corners go in and out, up and down. Precondition: a multiple
/// of 8.
inline Mesh many_fans(std::uint32_t valence) {
  Mesh mesh;
  const auto quarter = static_cast<double>(valence) / 4;
  for (std::uint32_t i = 0; i < valence; ++i) {
    const double along = 2 * (i % (valence / 4)) / quarter - 1;
    const std::array<Vec3, 4> sides{Vec3{1, along, 0}, Vec3{-along, 1, 0}, Vec3{-1, -along, 0},
                                    Vec3{along, -1, 0}};
    const Vec3 d = sides[i / (valence / 4)];
    const double radius = i % 2 == 0 ? 1000 : 300;
    const double height = i % 4 < 2 ? 40 : -40;
    mesh.vertices.push_back({std::nearbyint(d.x * radius), std::nearbyint(d.y * radius), height});
  }
  mesh.vertices.push_back({0, 0, 200});
  mesh.vertices.push_back({0, 0, -900});
  for (std::uint32_t i = 0; i < valence; ++i) {
    const std::uint32_t next = (i + 1) % valence;
    mesh.triangles.push_back({i, next, valence});
    mesh.triangles.push_back({next, i, valence + 1});
  }
  return mesh;
}

/// A tetrahedron a thousand times as wide as high, the origin in it.
inline Mesh flat_tetrahedron() {
  Mesh mesh;
  mesh.vertices = {{-1000, -1000, -1}, {1000, -1000, -1}, {0, 1000, -1}, {0, 0, 1}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  return mesh;
}

/// On the grid of 2^-20: beside a vertex, beside a point of an edge, or beside a point of a face.
inline Vec3 point_by_feature(const Mesh& mesh, Random& random) {
  const Triangle& t = mesh.triangles[random.below(mesh.triangles.size())];
  const Vec3 a = mesh.vertices[t[0]], b = mesh.vertices[t[1]], c = mesh.vertices[t[2]];
  const auto kind = random.below(3);
  const double u = kind == 0 ? 0 : static_cast<double>(random.below(17)) / 16;
  const double v = kind < 2 ? 0 : (1 - u) * static_cast<double>(random.below(17)) / 16;
  const double step = std::ldexp(1.0, static_cast<int>(random.below(24)) - 20);
  const auto place = [&](double p, double q, double r) {
    const double off = random.below(4) == 0 ? 0 : static_cast<double>(random.below(9)) - 4;
    return p + u * (q - p) + v * (r - p) + off * step;
  };
  return {place(a.x, b.x, c.x), place(a.y, b.y, c.y), place(a.z, b.z, c.z)};
}

}  // namespace cdfr::test
