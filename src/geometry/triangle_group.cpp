#include "geometry/triangle_group.h"

#include <cmath>

namespace cdfr {
namespace {

struct Segment {
  double ox, oy, oz;  ///< p minus the closest point of the segment
  double squared;
  double margin;  ///< > 0: the projection is certainly on the inner side
};

/// One edge of one triangle: e its direction, r = p - its first vertex, n the triangle's unit normal. No
/// branches, so that the compiler can put lanes side by side.
inline Segment beside(double ex, double ey, double ez, double rx, double ry, double rz, double nx, double ny,
                      double nz) noexcept {
  const double length = ex * ex + ey * ey + ez * ez;
  const double s = rx * ex + ry * ey + rz * ez;
  const double ratio = s / (length > 0 ? length : 1.0);
  const double clamped = ratio < 1 ? ratio : 1.0;
  const double t = clamped > 0 ? clamped : 0.0;
  Segment result;
  result.ox = rx - t * ex;
  result.oy = ry - t * ey;
  result.oz = rz - t * ez;
  result.squared = result.ox * result.ox + result.oy * result.oy + result.oz * result.oz;
  const double area = (ey * rz - ez * ry) * nx + (ez * rx - ex * rz) * ny + (ex * ry - ey * rx) * nz;
  result.margin = area - 16 * unit_roundoff * (std::fabs(ex) + std::fabs(ey) + std::fabs(ez)) *
                             (std::fabs(rx) + std::fabs(ry) + std::fabs(rz));
  return result;
}

struct Offset {
  double x, y, z, squared;
};

inline Offset offset_to(const Vec3& p, const TriangleGroup& group, std::size_t i) noexcept {
  const auto& v = group.vertices;
  const double nx = group.normals[0][i], ny = group.normals[1][i], nz = group.normals[2][i];
  const double ax = p.x - v[0][0][i], ay = p.y - v[0][1][i], az = p.z - v[0][2][i];
  const Segment s0 = beside(v[1][0][i] - v[0][0][i], v[1][1][i] - v[0][1][i], v[1][2][i] - v[0][2][i], ax, ay,
                            az, nx, ny, nz);
  const Segment s1 = beside(v[2][0][i] - v[1][0][i], v[2][1][i] - v[1][1][i], v[2][2][i] - v[1][2][i],
                            p.x - v[1][0][i], p.y - v[1][1][i], p.z - v[1][2][i], nx, ny, nz);
  const Segment s2 = beside(v[0][0][i] - v[2][0][i], v[0][1][i] - v[2][1][i], v[0][2][i] - v[2][2][i],
                            p.x - v[2][0][i], p.y - v[2][1][i], p.z - v[2][2][i], nx, ny, nz);
  const double height = nx * ax + ny * ay + nz * az;
  Offset best{s0.ox, s0.oy, s0.oz, s0.squared};
  const bool second = s1.squared < best.squared;
  best = {second ? s1.ox : best.x, second ? s1.oy : best.y, second ? s1.oz : best.z,
          second ? s1.squared : best.squared};
  const bool third = s2.squared < best.squared;
  best = {third ? s2.ox : best.x, third ? s2.oy : best.y, third ? s2.oz : best.z,
          third ? s2.squared : best.squared};
  const bool inside = (s0.margin > 0) & (s1.margin > 0) & (s2.margin > 0);
  return {inside ? height * nx : best.x, inside ? height * ny : best.y, inside ? height * nz : best.z,
          inside ? height * height : best.squared};
}

}  // namespace

void estimate_squared(const Vec3& p, const TriangleGroup& group, GroupDistances& squared) noexcept {
  for (std::size_t i = 0; i < group_size; ++i) squared[i] = offset_to(p, group, i).squared;
}

Vec3 estimate_closest(const Vec3& p, const TriangleGroup& group, std::size_t lane) noexcept {
  const Offset o = offset_to(p, group, lane);
  return {p.x - o.x, p.y - o.y, p.z - o.z};
}

}  // namespace cdfr
