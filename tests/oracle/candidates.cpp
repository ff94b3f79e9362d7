#include "oracle/candidates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "oracle/exact_number.h"

namespace cdfr::oracle {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

Vec3 minus(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
double dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
double length(Vec3 a) { return std::sqrt(dot(a, a)); }

using Corners = std::array<Vec3, 3>;

/// Corners of the triangle as seen from p.
Corners corners(MeshView mesh, std::uint32_t number, Vec3 p) {
  const Triangle& t = mesh.triangles[number];
  return {minus(mesh.vertices[t[0]], p), minus(mesh.vertices[t[1]], p), minus(mesh.vertices[t[2]], p)};
}

/// (1 - s - t) v0 + s v1 + t v2.
Vec3 combine(const Corners& v, double s, double t) {
  const double r = 1 - s - t;
  return {r * v[0].x + s * v[1].x + t * v[2].x, r * v[0].y + s * v[1].y + t * v[2].y,
          r * v[0].z + s * v[1].z + t * v[2].z};
}

/// Share of the way from v to w at which the segment is nearest to the origin.
double share(Vec3 v, Vec3 w) {
  const Vec3 e = minus(w, v);
  const double square = dot(e, e);
  return square > 0 ? std::clamp(-dot(v, e) / square, 0.0, 1.0) : 0;
}

/// A point of the triangle that is near the origin, usually the nearest one.
Vec3 near_origin(const Corners& v) {
  Vec3 best = v[0];
  const auto offer = [&](Vec3 y) {
    if (dot(y, y) < dot(best, best)) best = y;
  };
  offer(combine(v, share(v[0], v[1]), 0));
  offer(combine(v, 0, share(v[0], v[2])));
  const double t = share(v[1], v[2]);
  offer(combine(v, 1 - t, t));
  const Vec3 e = minus(v[1], v[0]);
  const Vec3 f = minus(v[2], v[0]);
  const double det = dot(e, e) * dot(f, f) - dot(e, f) * dot(e, f);
  const double s_face = (dot(e, f) * dot(f, v[0]) - dot(f, f) * dot(e, v[0])) / det;
  const double t_face = (dot(e, f) * dot(e, v[0]) - dot(e, e) * dot(f, v[0])) / det;
  if (s_face >= 0 && t_face >= 0 && s_face + t_face <= 1) offer(combine(v, s_face, t_face));
  return best;
}

/// Distance of a half-space that holds the triangle and whose border is normal to y.
double half_space(const Corners& v, Vec3 y) {
  const double size = length(y);
  if (!(size > 0) || size == infinity) return -infinity;
  const Vec3 u{y.x / size, y.y / size, y.z / size};
  return std::min({dot(u, v[0]), dot(u, v[1]), dot(u, v[2])});
}

}  // namespace

Candidates::Candidates(MeshView mesh) : mesh_(mesh) {
  spheres_.reserve(mesh.triangles.size());
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    const Corners v = corners(mesh, i, {});
    const Vec3 centre = combine(v, 1.0 / 3, 1.0 / 3);
    const double radius =
        std::max({length(minus(v[0], centre)), length(minus(v[1], centre)), length(minus(v[2], centre))});
    spheres_.push_back({centre, radius});
    largest_ = std::max(largest_, largest_coordinate(v));
  }
}

std::vector<std::uint32_t> Candidates::near(Vec3 p) const {
  const double slack = std::ldexp(std::max(largest_, largest_coordinate(p)), -40);
  std::vector<double> to_centre(spheres_.size());
  double upper = infinity;
  for (std::size_t i = 0; i < spheres_.size(); ++i) {
    to_centre[i] = length(minus(spheres_[i].centre, p));
    upper = std::min(upper, to_centre[i]);
  }
  struct Bound {
    std::uint32_t triangle;
    double lower;
  };
  std::vector<Bound> bounds;
  for (std::uint32_t i = 0; i < spheres_.size(); ++i) {
    if (to_centre[i] - spheres_[i].radius > upper + slack) continue;
    const Corners v = corners(mesh_, i, p);
    const Vec3 y = near_origin(v);
    upper = std::min(upper, length(y));
    bounds.push_back({i, half_space(v, y)});
  }
  std::vector<std::uint32_t> result;
  for (const Bound& bound : bounds) {
    if (!(bound.lower > upper + slack)) result.push_back(bound.triangle);
  }
  return result;
}

}  // namespace cdfr::oracle
