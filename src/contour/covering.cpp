#include "contour/covering.h"

#include <Eigen/Geometry>

#include <array>
#include <cmath>

#include "core/vector.h"

namespace cdfr {
namespace {

/// A vertex by what is linear in its place: (y - c) x g, which turns the projection by a right angle, and the
/// height above the plane.
struct Projected {
  Eigen::Vector3d across;
  double height;
};

/// A triangle gains at most one vertex from each of six half planes.
struct Polygon {
  std::array<Projected, 9> vertices;
  std::size_t size = 0;
};

/// Keeps what has sign * across[axis] <= limit.
void clip(Polygon& polygon, Eigen::Index axis, double sign, double limit) noexcept {
  Polygon kept;
  for (std::size_t i = 0; i < polygon.size; ++i) {
    const Projected& from = polygon.vertices[i];
    const Projected& to = polygon.vertices[i + 1 == polygon.size ? 0 : i + 1];
    const double at = limit - sign * from.across[axis], next = limit - sign * to.across[axis];
    if (at >= 0) kept.vertices[kept.size++] = from;
    if ((at >= 0) != (next >= 0) && kept.size < kept.vertices.size()) {
      const double share = at / (at - next);
      kept.vertices[kept.size++] = {from.across + share * (to.across - from.across),
                                    from.height + share * (to.height - from.height)};
    }
    if (kept.size == kept.vertices.size()) break;
  }
  polygon = kept;
}

double signed_area(const Polygon& polygon, const Eigen::Vector3d& gradient) noexcept {
  double twice = 0;
  for (std::size_t i = 2; i < polygon.size; ++i) {
    const Eigen::Vector3d u = polygon.vertices[i - 1].across - polygon.vertices[0].across;
    const Eigen::Vector3d v = polygon.vertices[i].across - polygon.vertices[0].across;
    twice += gradient.dot(u.cross(v));
  }
  return twice / 2;
}

}  // namespace

bool covers(const FieldData& field, const Eigen::Vector3d& centre, double size,
            const Eigen::Vector3d& gradient, double value, double slack,
            const std::vector<NearTriangle>& near) {
  const Eigen::Vector3d g = gradient.cwiseAbs();
  const Eigen::Vector3d limit = Eigen::Vector3d(g[1] + g[2], g[0] + g[2], g[0] + g[1]) * (size / 2);
  const double hexagon = size * size * (g[0] + g[1] + g[2]);
  double area = 0;
  for (const NearTriangle& triangle : near) {
    Polygon polygon;
    for (const Vec3& vertex : field.triangles.shape(triangle.slot).vertices) {
      const Eigen::Vector3d w = to_eigen(vertex) - centre;
      polygon.vertices[polygon.size++] = {w.cross(gradient), gradient.dot(w) + value};
    }
    for (Eigen::Index axis = 0; axis < 3 && polygon.size > 0; ++axis) {
      for (const double sign : {-1.0, 1.0}) {
        bool outside = false;
        for (std::size_t i = 0; i < polygon.size; ++i)
          outside |= sign * polygon.vertices[i].across[axis] > limit[axis];
        if (outside) clip(polygon, axis, sign, limit[axis]);
      }
    }
    bool flat = polygon.size > 2;
    for (std::size_t i = 0; i < polygon.size; ++i)
      flat = flat && std::fabs(polygon.vertices[i].height) <= slack;
    if (flat) area += signed_area(polygon, gradient);
  }
  return std::fabs(area) >= hexagon * (1 - 0x1p-24);
}

}  // namespace cdfr
