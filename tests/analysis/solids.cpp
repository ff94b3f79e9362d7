#include "analysis/solids.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <vector>

#include "analysis/ear_cut.h"
#include "parts/prism.h"

namespace cdfr::test {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double on_axis = 1e-12;

}  // namespace

double Extrusion::depth(const Vec3& p) const {
  return std::min({profile.depth({p.x, p.y}), p.z, height - p.z});
}

Mesh Extrusion::mesh(double chord) const {
  const std::vector<Point2> ring = profile.points(chord);
  const auto count = static_cast<std::uint32_t>(ring.size());
  Mesh mesh;
  for (const double z : {0.0, height}) {
    for (const Point2 p : ring) mesh.vertices.push_back({p.x, p.y, z});
  }
  const auto caps = cut_ears(ring);
  for (const auto& [a, b, c] : caps) mesh.triangles.push_back({a, c, b});
  for (const auto& [a, b, c] : caps) mesh.triangles.push_back({a + count, b + count, c + count});
  mesh.patches.assign(caps.size(), 0);
  mesh.patches.insert(mesh.patches.end(), caps.size(), 1);
  add_wall(mesh, 0, count, count);
  mesh.patches.resize(mesh.triangles.size(), 2);
  mesh.patch_names = {"bottom", "top", "side"};
  return mesh;
}

// Pappus and Guldin.
double Revolution::volume() const { return 2 * pi * profile.moment(); }
double Revolution::area() const { return 2 * pi * profile.swept_length(); }

double Revolution::depth(const Vec3& p) const { return profile.depth({std::hypot(p.x, p.y), p.z}, true); }

Mesh Revolution::mesh(double chord) const {
  const std::vector<Point2> points = profile.points(chord / 2);
  double farthest = 0;
  for (const Point2 p : points) farthest = std::max(farthest, p.x);
  const auto quarter = static_cast<std::uint32_t>(std::ceil(pi / 4 / std::acos(1 - chord / 2 / farthest)));
  const std::uint32_t sides = 4 * quarter;
  Mesh mesh;
  std::vector<std::uint32_t> first;  // vertex of each point's ring
  for (const Point2 p : points) {
    first.push_back(static_cast<std::uint32_t>(mesh.vertices.size()));
    if (p.x < on_axis) {
      mesh.vertices.push_back({0, 0, p.y});
      continue;
    }
    for (std::uint32_t k = 0; k < sides; ++k) {
      const double angle = 2 * pi * k / sides;
      mesh.vertices.push_back({p.x * std::cos(angle), p.x * std::sin(angle), p.y});
    }
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::size_t next = (i + 1) % points.size();
    const bool low_pole = points[i].x < on_axis, high_pole = points[next].x < on_axis;
    for (std::uint32_t k = 0; k < sides && !(low_pole && high_pole); ++k) {
      const std::uint32_t l = (k + 1) % sides;
      const std::uint32_t a = first[i] + (low_pole ? 0 : k), b = first[i] + (low_pole ? 0 : l);
      const std::uint32_t c = first[next] + (high_pole ? 0 : l), d = first[next] + (high_pole ? 0 : k);
      if (!low_pole) mesh.triangles.push_back({a, b, c});
      if (!high_pole) mesh.triangles.push_back({a, c, d});
    }
  }
  return mesh;
}

}  // namespace cdfr::test
