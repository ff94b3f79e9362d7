#include "oracle/exact_side.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "oracle/exact_distance.h"
#include "oracle/exact_number.h"

namespace cdfr::oracle {
namespace {

using Corners = std::array<Vec3, 3>;
enum class Crossing { none, entering, leaving, undecided };

int sign(double x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }

bool in_box(Vec3 p, const Corners& v) {
  const auto [x0, x1] = std::minmax({v[0].x, v[1].x, v[2].x});
  const auto [y0, y1] = std::minmax({v[0].y, v[1].y, v[2].y});
  const auto [z0, z1] = std::minmax({v[0].z, v[1].z, v[2].z});
  return x0 <= p.x && p.x <= x1 && y0 <= p.y && p.y <= y1 && z0 <= p.z && p.z <= z1;
}

/// Sign of det(d, u, v) where it is certain, else 0. u and v carry one rounding of a subtraction each, d
/// none, and each of the six products two more, the sums five: fewer than 16 roundings of terms no larger
/// than the product of the largest coordinates, six of them; 2^-46 of that product is more than 6 * 16 *
/// 2^-53 of it.
int certain_sign(Vec3 d, Vec3 u, Vec3 v) {
  const double det =
      d.x * (u.y * v.z - u.z * v.y) + d.y * (u.z * v.x - u.x * v.z) + d.z * (u.x * v.y - u.y * v.x);
  const double size = largest_coordinate(d) * largest_coordinate(u) * largest_coordinate(v);
  const bool safe = size > 0x1p-900 && size < 0x1p900;
  return safe && std::abs(det) > std::ldexp(size, -46) ? sign(det) : 0;
}

/// A quick and certain "the whole line misses": it passes on different sides of two edges.
bool surely_missed(Vec3 p, Vec3 d, const Corners& v) {
  std::array<Vec3, 3> u;
  for (std::size_t i = 0; i < 3; ++i) u[i] = {v[i].x - p.x, v[i].y - p.y, v[i].z - p.z};
  const int s0 = certain_sign(d, u[0], u[1]);
  const int s1 = certain_sign(d, u[1], u[2]);
  if (s0 * s1 < 0) return true;
  const int s2 = certain_sign(d, u[2], u[0]);
  return s0 * s2 < 0 || s1 * s2 < 0;
}

/// The three signs say where the line through p along d passes the edges; they add up to n . d as numbers.
/// Signs that differ: it misses. All alike: it crosses the inside, towards the front if they are positive,
/// and does so ahead of p if n . (a - p) has the same sign. Zero among like ones: it meets the border, or the
/// triangle is seen edge-on. A triangle of no area is never crossed: its border covers each of its points as
/// often one way as the other, so the triangles that do have an area close up without it.
Crossing crossing(Vec3 p, Vec3 d, const Corners& v) {
  const std::array<Vec3, 4> points{p, v[0], v[1], v[2]};
  const int exponent = common_exponent(points);
  const IntegerVector origin = on_lattice(p, exponent);
  const IntegerVector ray = on_lattice(d, 0);
  std::array<IntegerVector, 3> u;
  for (std::size_t i = 0; i < 3; ++i) u[i] = on_lattice(v[i], exponent) - origin;
  int positive = 0;
  int negative = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const int s = sgn(dot(ray, cross(u[i], u[(i + 1) % 3])));
    positive += s > 0;
    negative += s < 0;
  }
  if (positive > 0 && negative > 0) return Crossing::none;
  const IntegerVector normal = cross(u[1] - u[0], u[2] - u[0]);
  if (positive + negative < 3) return dot(normal, normal) == 0 ? Crossing::none : Crossing::undecided;
  const int ahead = sgn(dot(normal, u[0]));
  if (ahead != (positive > 0 ? 1 : -1)) return Crossing::none;
  return positive > 0 ? Crossing::leaving : Crossing::entering;
}

Corners corners(MeshView mesh, const Triangle& t) {
  return {mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]};
}

bool on_surface(MeshView mesh, Vec3 p) {
  return std::ranges::any_of(mesh.triangles, [&](const Triangle& t) {
    const Corners v = corners(mesh, t);
    return in_box(p, v) && exact_distance(p, v[0], v[1], v[2]).squared.numerator == 0;
  });
}

/// None if the ray meets an edge or corner.
std::optional<int> count_crossings(MeshView mesh, Vec3 p, Vec3 d) {
  int winding = 0;
  for (const Triangle& t : mesh.triangles) {
    const Corners v = corners(mesh, t);
    if (surely_missed(p, d, v)) continue;
    const Crossing found = crossing(p, d, v);
    if (found == Crossing::undecided) return std::nullopt;
    winding += found == Crossing::leaving ? 1 : found == Crossing::entering ? -1 : 0;
  }
  return winding;
}

}  // namespace

Vec3 ray_direction(int attempt) {
  std::uint64_t state = 0x5DEECE66DU + 7919U * static_cast<std::uint64_t>(attempt);
  const auto next = [&] {
    state = state * 6364136223846793005U + 1442695040888963407U;
    return static_cast<double>(static_cast<std::int64_t>(state >> 44) - (1 << 19));
  };
  const double x = next();
  const double y = next();
  return {x, y, next()};
}

std::optional<int> exact_winding(MeshView closed_mesh, Vec3 p) {
  if (on_surface(closed_mesh, p)) return std::nullopt;
  for (int attempt = 0;; ++attempt) {
    // A ray of random direction meets one of finitely many edges with a chance of about edges / 2^40.
    if (attempt == 1000) std::abort();
    if (const std::optional<int> winding = count_crossings(closed_mesh, p, ray_direction(attempt)))
      return winding;
  }
}

int exact_side(MeshView closed_mesh, Vec3 p) {
  const std::optional<int> winding = exact_winding(closed_mesh, p);
  return !winding ? 0 : *winding != 0 ? -1 : 1;
}

}  // namespace cdfr::oracle
