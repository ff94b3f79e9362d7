#include "oracle/wall_oracle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace cdfr::oracle {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Radii between which r - depth(p - r n) passes the tolerance.
Range bisected(const Depth& depth, const Wall& wall, double tolerance) {
  const Vec3 &p = wall.point, &n = wall.normal;
  const auto holds = [&](double r) {
    return r - depth({p.x - r * n.x, p.y - r * n.y, p.z - r * n.z}) <= tolerance;
  };
  Range radius{0, wall.largest / 2};
  if (!holds(0)) return {0, 0};
  if (holds(radius.high)) return {infinity, infinity};
  while (radius.high - radius.low > 1e-15 * wall.largest) {
    const double middle = (radius.low + radius.high) / 2;
    (holds(middle) ? radius.low : radius.high) = middle;
  }
  return radius;
}

using Real = long double;
using Vector = std::array<Real, 3>;

Vector minus(const Vec3& a, const Vec3& b) {
  return {Real{a.x} - Real{b.x}, Real{a.y} - Real{b.y}, Real{a.z} - Real{b.z}};
}
Real dot(const Vector& u, const Vector& v) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; }
Vector cross(const Vector& u, const Vector& v) {
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

/// Where the ray meets the triangle's plane, and how far inside the triangle that is: its least barycentric
/// coordinate. Edge-on it is not met: there its neighbours are.
struct Meeting {
  Real way = 0, inside = -1;
};

Meeting meet(MeshView mesh, const Triangle& t, const Vec3& from, const Vec3& along) {
  const Vec3 a = mesh.vertices[t[0]];
  const Vector ab = minus(mesh.vertices[t[1]], a), ac = minus(mesh.vertices[t[2]], a), way = minus(along, {});
  const Vector side = cross(way, ac), offset = minus(from, a), other = cross(offset, ab);
  const Real scale = dot(ab, side);
  if (scale == 0) return {};
  const Real v = dot(offset, side) / scale, w = dot(way, other) / scale;
  return {dot(ac, other) / scale, std::min({v, w, 1 - v - w})};
}

}  // namespace

Range ball_diameter(const Depth& depth, const Wall& wall) {
  return {2 * bisected(depth, wall, wall.facet - wall.uncertain).low,
          2 * bisected(depth, wall, wall.facet + wall.uncertain).high};
}

Range first_hit(MeshView mesh, const Vec3& point, const Vec3& normal, std::uint32_t own) {
  constexpr Real doubtful = 1e-12L;
  Range way{infinity, infinity};
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    if (i == own) continue;
    const Meeting meeting = meet(mesh, mesh.triangles[i], point, {-normal.x, -normal.y, -normal.z});
    if (meeting.inside < -doubtful || meeting.way < 0) continue;
    const auto here = static_cast<double>(meeting.way);
    way.low = std::min(way.low, here);
    if (meeting.inside > doubtful) way.high = std::min(way.high, here);
  }
  return way;
}

}  // namespace cdfr::oracle
