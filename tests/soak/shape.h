/// A made mesh with the numbers that it was made with.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cdfr/mesh/mesh.h"
#include "support/random.h"

namespace cdfr::soak {

struct Shape {
  std::string text;  ///< what it is, for the reader: "wedge 1e-9"
  Mesh mesh;
};

/// A family makes the shape of a round: rounds differ in parameters, and go through the extreme ones first.
struct Family {
  const char* name;
  Shape (*make)(std::uint64_t round, test::Random& random);
};

/// 1 / 10^n, the same on every machine.
inline double tenth(std::uint64_t n) noexcept {
  double power = 1;
  for (std::uint64_t i = 0; i < n; ++i) power *= 10;
  return 1 / power;
}

/// "1e-n".
inline std::string tenth_text(std::uint64_t n) { return "1e-" + std::to_string(n); }

/// A number from first to last, in steps that soon come close to every one of them.
inline std::uint64_t strided(std::uint64_t round, std::uint64_t first, std::uint64_t last) noexcept {
  const std::uint64_t count = last - first + 1;
  std::uint64_t step = count * 5 / 8 + 1;
  const auto common = [](std::uint64_t a, std::uint64_t b) {
    while (b != 0) a %= b, std::swap(a, b);
    return a;
  };
  while (common(step, count) != 1) ++step;
  return first + (count - 1 + round * step) % count;
}

/// A point of the unit circle for u in 0 .. 1, by the rational parametrisation of each quadrant: plain
/// arithmetic, so the same everywhere.
struct OnCircle {
  double x = 1, y = 0;
};
inline OnCircle on_circle(double u) noexcept {
  u -= static_cast<double>(static_cast<long>(u));
  const int quadrant = static_cast<int>(4 * u);
  const double t = 4 * u - quadrant, size = 1 + t * t;
  const double x = (1 - t * t) / size, y = 2 * t / size;
  switch (quadrant) {
    case 0:
      return {x, y};
    case 1:
      return {-y, x};
    case 2:
      return {-x, -y};
    default:
      return {y, -x};
  }
}

/// Grows a mesh.
inline std::uint32_t add_vertex(Mesh& mesh, const Vec3& v) {
  mesh.vertices.push_back(v);
  return static_cast<std::uint32_t>(mesh.vertices.size() - 1);
}
/// Corners in the order of a counterclockwise walk seen from outside, cut along the first and third.
inline void add_quad(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
  mesh.triangles.push_back({a, b, c});
  mesh.triangles.push_back({a, c, d});
}
inline void add_mesh(Mesh& mesh, const Mesh& other, bool reversed) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
  for (const Triangle& t : other.triangles) {
    const std::uint32_t a = t[0] + first, b = t[1] + first, c = t[2] + first;
    mesh.triangles.push_back(reversed ? Triangle{a, c, b} : Triangle{a, b, c});
  }
}

/// Turned so that its normals point outward, going by the volume.
Mesh outward(Mesh mesh);

}  // namespace cdfr::soak
