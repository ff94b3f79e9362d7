#include "mesh/crossings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "geometry/box_distance.h"
#include "geometry/expansion.h"
#include "geometry/offset.h"
#include "geometry/query_range.h"
#include "geometry/solid_angle.h"

namespace cdfr {
namespace {

/// Only a mesh that was made for it spoils so many rays.
constexpr std::uint32_t most_attempts = 64;

using ExactVector = std::array<Expansion<4>, 3>;

/// A ray whose origin is a sum of up to three points, known exactly; `near` is that sum rounded, off by at
/// most `doubt` in each coordinate.
struct Ray {
  std::array<Vec3, 3> parts;
  Vec3 near;
  double doubt = 0;
  Vec3 direction;  ///< multiples of 2^-38 up to 1
};

/// False only if the ray certainly misses the box: one of six axes separates them by more than rounding.
bool may_meet(const Ray& ray, const Box& box) noexcept {
  const double d[3] = {ray.direction.x, ray.direction.y, ray.direction.z};
  const Vec3 below = minus(box.lo, ray.near), above = minus(box.hi, ray.near);
  const double lo[3] = {below.x, below.y, below.z};
  const double hi[3] = {above.x, above.y, above.z};
  for (int i = 0; i < 3; ++i) {
    if (d[i] >= 0 && hi[i] < -ray.doubt) return false;
    if (d[i] <= 0 && lo[i] > ray.doubt) return false;
  }
  // Axis d x e_i: the box's radius against the ray's line, relative to the origin.
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const double hj = (hi[j] - lo[j]) / 2, hk = (hi[k] - lo[k]) / 2;
    const double cj = lo[j] + hj, ck = lo[k] + hk;
    const double away = std::fabs(d[j] * ck - d[k] * cj);
    const double radius = std::fabs(d[j]) * hk + std::fabs(d[k]) * hj;
    const double size = std::fabs(lo[j]) + std::fabs(hi[j]) + std::fabs(lo[k]) + std::fabs(hi[k]) + ray.doubt;
    const double rounding = (std::fabs(d[j]) + std::fabs(d[k])) * (32 * unit_roundoff * size + 2 * ray.doubt);
    if (away > radius + rounding) return false;
  }
  return true;
}

/// Sign of det(a, b, c) where it is certain, else 0. Each component carries one rounding, those of a up to
/// doubt_a more and those of b and c up to `doubt`; the six products round by less than 8u each, so 2^-46 of
/// the product of the largest components covers them, and a doubt in one vector moves six products of the two
/// others.
int certain_sign(const Vec3& a, const Vec3& b, const Vec3& c, double doubt_a, double doubt) noexcept {
  const double determinant =
      a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) + a.z * (b.x * c.y - b.y * c.x);
  const double sa = largest_magnitude(a), sb = largest_magnitude(b) + doubt,
               sc = largest_magnitude(c) + doubt;
  const double bound = 0x1p-46 * sa * sb * sc + 8 * (doubt_a * sb * sc + sa * doubt * (sb + sc));
  if (determinant > bound) return 1;
  return determinant < -bound ? -1 : 0;
}

ExactVector exact_offset(const Vec3& t, const Ray& ray) noexcept {
  ExactVector u;
  u[0].add(t.x);
  u[1].add(t.y);
  u[2].add(t.z);
  for (const Vec3& part : ray.parts) {
    u[0].add(-part.x);
    u[1].add(-part.y);
    u[2].add(-part.z);
  }
  return u;
}

std::array<Expansion<2>, 3> exactly(const Vec3& d) noexcept {
  return {exact_difference(d.x, 0), exact_difference(d.y, 0), exact_difference(d.z, 0)};
}

template <class A>
int exact_sign(const A& a, const ExactVector& b, const ExactVector& c) noexcept {
  const auto x = a[0] * (b[1] * c[2] - b[2] * c[1]);
  const auto y = a[1] * (b[2] * c[0] - b[0] * c[2]);
  const auto z = a[2] * (b[0] * c[1] - b[1] * c[0]);
  return (x + y + z).sign();
}

/// Sign of direction . normal of the triangle, exactly.
int rises(const Vec3& d, const std::array<Vec3, 3>& t) noexcept {
  const auto along = [&](std::size_t k) { return exact_offset(t[k], {{t[0], {}, {}}, {}, 0, {}}); };
  return exact_sign(exactly(d), along(1), along(2));
}

/// A triangle as a ray sees it.
class Crossing {
 public:
  Crossing(const Ray& ray, const std::array<Vec3, 3>& t) noexcept : ray_(ray), t_(t) {
    for (std::size_t k = 0; k < 3; ++k) near_[k] = minus(t[k], ray.near);
  }

  /// 1 leaving, -1 entering, 0 none; nothing if the ray meets the border or lies in the plane. The signs say
  /// on which side of each edge the line passes, and add up, as numbers, to direction . normal. Where the
  /// origin is in the plane, the line meets the plane there alone, and that is off the triangle.
  std::optional<int> counted() const noexcept {
    int positive = 0, negative = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const int side = edge_side(k, (k + 1) % 3);
      positive += side > 0;
      negative += side < 0;
      if (positive > 0 && negative > 0) return 0;
    }
    if (positive + negative == 0) return std::nullopt;
    const int towards = positive > 0 ? 1 : -1;
    if (plane_side() != towards) return 0;
    return positive + negative == 3 ? std::optional(towards) : std::nullopt;
  }

 private:
  /// Sign of det(direction, t[i] - origin, t[j] - origin).
  int edge_side(std::size_t i, std::size_t j) const noexcept {
    const Vec3& d = ray_.direction;
    if (const int sign = certain_sign(d, near_[i], near_[j], 0, ray_.doubt)) return sign;
    return exact_sign(exactly(d), exact_offset(t_[i], ray_), exact_offset(t_[j], ray_));
  }
  /// 1 if the origin is behind the triangle, -1 in front: sign of det(t[0] - origin, t[1] - origin, t[2] -
  /// origin).
  int plane_side() const noexcept {
    if (const int sign = certain_sign(near_[0], near_[1], near_[2], ray_.doubt, ray_.doubt)) return sign;
    return exact_sign(exact_offset(t_[0], ray_), exact_offset(t_[1], ray_), exact_offset(t_[2], ray_));
  }

  const Ray& ray_;
  const std::array<Vec3, 3>& t_;
  std::array<Vec3, 3> near_;
};

/// Nothing if some triangle but `except` leaves it open.
std::optional<int> winding_along(const Ray& ray, SearchSpace space, std::uint32_t except) noexcept {
  int winding = 0;
  const auto enter = [&](std::uint32_t index) { return may_meet(ray, space.bvh.nodes[index].box); };
  const auto count = [&](std::uint32_t index) {
    const std::uint32_t number = space.bvh.nodes[index].first_group;
    const std::uint32_t first = number * std::uint32_t{group_size};
    for (std::uint32_t slot = first; slot < first + space.triangles.lanes(number); ++slot) {
      // The border of a triangle of no area covers each of its points as often one way as the other, so those
      // that have an area close up without it.
      const TriangleShape& shape = space.triangles.shape(slot);
      if (slot == except || rounded(shape.normal) == Vec3{}) continue;
      const std::optional<int> c = Crossing(ray, shape.vertices).counted();
      if (!c) return false;
      winding += *c;
    }
    return true;
  };
  return walk(space.bvh, 0, enter, count) ? std::optional(winding) : std::nullopt;
}

/// Of all triangles but one: for meshes made so that every ray is spoilt.
double sum_of_angles(const Vec3& p, SearchSpace space, std::uint32_t except) noexcept {
  double sum = 0;
  for (std::uint32_t slot = 0; slot < space.triangles.size(); ++slot) {
    if (slot != except) sum += solid_angle(p, space.triangles.shape(slot).vertices).value;
  }
  return sum;
}

}  // namespace

/// Any three points of this curve are independent (Vandermonde). t runs over the 2^20 multiples of 2^-19 in
/// [-1, 1) in a scattered order, so that t^2 is exact.
Vec3 ray_direction(std::uint32_t attempt) noexcept {
  const std::uint32_t place = (attempt * 0x9e375U + 0x5a827U) & 0xfffffU;
  const double t = static_cast<double>(place) * 0x1p-19 - 1;
  return {1, t, t * t};
}

std::optional<int> crossings_along(const Vec3& p, const Vec3& direction, SearchSpace space) noexcept {
  return winding_along({{p, {}, {}}, p, 0, direction}, space, no_index);
}

int winding_by_crossings(const Vec3& p, SearchSpace space) noexcept {
  if (!contains(space.bvh.nodes[0].box, p)) return 0;
  for (std::uint32_t attempt = 0; attempt < most_attempts; ++attempt) {
    if (const std::optional<int> winding = crossings_along(p, ray_direction(attempt), space)) return *winding;
  }
  return static_cast<int>(std::lround(sum_of_angles(p, space, no_index) / four_pi));
}

int winding_in_front(std::uint32_t slot, SearchSpace space) noexcept {
  const std::array<Vec3, 3> v = space.triangles.shape(slot).vertices;
  const auto times = [](const Vec3& p, double f) { return Vec3{f * p.x, f * p.y, f * p.z}; };
  Ray ray{{times(v[0], 0.5), times(v[1], 0.25), times(v[2], 0.25)}, {}, 0, {}};
  const auto& [a, b, c] = ray.parts;
  ray.near = {a.x + b.x + c.x, a.y + b.y + c.y, a.z + b.z + c.z};
  ray.doubt = 4 * unit_roundoff *
              std::max({largest_magnitude(v[0]), largest_magnitude(v[1]), largest_magnitude(v[2])});
  for (std::uint32_t attempt = 0; attempt < most_attempts; ++attempt) {
    ray.direction = ray_direction(attempt);
    const int towards = rises(ray.direction, v);
    if (towards == 0) continue;
    const std::optional<int> winding = winding_along(ray, space, slot);
    // What the ray counts is the winding on the side that it starts on, and behind it is one more.
    if (winding) return towards > 0 ? *winding : *winding - 1;
  }
  // Seen from just off its front the triangle itself takes up minus half a turn.
  return static_cast<int>(std::lround(sum_of_angles(ray.near, space, slot) / four_pi - 0.5));
}

}  // namespace cdfr
