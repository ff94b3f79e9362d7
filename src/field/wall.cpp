#include "field/wall.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

#include "core/vector.h"
#include "geometry/orientation.h"

namespace cdfr {
namespace {

/// The shared edge from `from` to `to`, and the two vertices that are not on it.
struct Seam {
  Vec3 from, to, left, right;
};

std::optional<Seam> shared_edge(const TriangleShape& a, const TriangleShape& b) noexcept {
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const Vec3 &from = a.vertices[i], &to = a.vertices[(i + 1) % 3];
      if (from == b.vertices[(j + 1) % 3] && to == b.vertices[j]) {
        return Seam{from, to, a.vertices[(i + 2) % 3], b.vertices[(j + 2) % 3]};
      }
    }
  }
  return std::nullopt;
}

/// A triangle above the edge (0,0)-(length,0) with its apex at (u, v), v > 0: is the rectangle [u0,u1] x
/// [0,v1] in it?
bool holds_rectangle(double length, double u, double v, double u0, double u1, double v1) noexcept {
  if (u0 < 0 || u1 > length || v1 > v) return false;
  return u * v1 <= u0 * v && (length - u) * v1 <= (length - u1) * v;
}

}  // namespace

std::optional<std::array<double, 8>> wall_heights(const TriangleShape& a, const TriangleShape& b,
                                                  std::span<const Vec3, 8> corners) noexcept {
  const std::optional<Seam> seam = shared_edge(a, b);
  if (!seam || orientation(a.vertices[0], a.vertices[1], a.vertices[2], seam->right) != 0)
    return std::nullopt;
  const Eigen::Vector3d origin = to_eigen(seam->from);
  const Eigen::Vector3d normal = to_eigen(rounded(a.normal));
  Eigen::Vector3d along = to_eigen(seam->to) - origin;
  const double length = along.norm();
  if (normal.isZero(0) || !(length > 0)) return std::nullopt;
  along /= length;
  const Eigen::Vector3d inward = normal.cross(along);
  const auto u = [&](const Vec3& p) { return along.dot(to_eigen(p) - origin); };
  const auto v = [&](const Vec3& p) { return inward.dot(to_eigen(p) - origin); };
  double u0 = HUGE_VAL, u1 = -HUGE_VAL, above = 0, below = 0;
  std::array<double, 8> heights;
  for (std::size_t i = 0; i < 8; ++i) {
    u0 = std::min(u0, u(corners[i]));
    u1 = std::max(u1, u(corners[i]));
    above = std::max(above, v(corners[i]));
    below = std::max(below, -v(corners[i]));
    heights[i] = std::fabs(normal.dot(to_eigen(corners[i]) - origin));
  }
  const bool held = holds_rectangle(length, u(seam->left), v(seam->left), u0, u1, above) &&
                    holds_rectangle(length, u(seam->right), -v(seam->right), u0, u1, below);
  if (!held) return std::nullopt;
  return heights;
}

}  // namespace cdfr
