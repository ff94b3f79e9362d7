#include "mesh/crossings.h"

#include <array>
#include <cassert>
#include <cmath>
#include <optional>

#include "geometry/box_distance.h"
#include "geometry/orientation.h"

namespace cdfr {
namespace {

struct Segment {
  Vec3 from, to;
};

/// False only if the segment certainly misses the box: one of three axes separates them by more than
/// rounding.
bool may_meet(const Segment& s, const Box& box) noexcept {
  const auto apart = [](double a, double b, double lo, double hi) {
    return (a < lo && b < lo) || (a > hi && b > hi);
  };
  if (apart(s.from.x, s.to.x, box.lo.x, box.hi.x) || apart(s.from.y, s.to.y, box.lo.y, box.hi.y) ||
      apart(s.from.z, s.to.z, box.lo.z, box.hi.z)) {
    return false;
  }
  // Axis d x e_i: the box's radius against the segment's line, everything relative to `from`.
  const double d[3] = {s.to.x - s.from.x, s.to.y - s.from.y, s.to.z - s.from.z};
  const double h[3] = {(box.hi.x - box.lo.x) / 2, (box.hi.y - box.lo.y) / 2, (box.hi.z - box.lo.z) / 2};
  const double c[3] = {box.lo.x - s.from.x + h[0], box.lo.y - s.from.y + h[1], box.lo.z - s.from.z + h[2]};
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const double away = std::fabs(d[j] * c[k] - d[k] * c[j]);
    const double radius = std::fabs(d[j]) * h[k] + std::fabs(d[k]) * h[j];
    const double size =
        (std::fabs(d[j]) + std::fabs(d[k])) * (std::fabs(c[j]) + std::fabs(c[k]) + h[j] + h[k]);
    if (away > radius + 32 * unit_roundoff * size) return false;
  }
  return true;
}

/// Crossing of one triangle: 1 leaving, -1 entering, 0 none; nothing if exactness leaves it open.
std::optional<int> crossing(const Segment& s, const std::array<Vec3, 3>& t) noexcept {
  const int here = orientation(t[0], t[1], t[2], s.from);
  const int there = orientation(t[0], t[1], t[2], s.to);
  if (here == 0 && there == 0) return std::nullopt;
  // A point of the segment in the plane that is an end of it is not on the triangle: p is off the surface,
  // the other end outside the box.
  if (here * there >= 0) return 0;
  int positive = 0, negative = 0;
  for (int k = 0; k < 3; ++k) {
    const int side = orientation(s.from, s.to, t[k], t[(k + 1) % 3]);
    positive += side > 0;
    negative += side < 0;
  }
  if (positive > 0 && negative > 0) return 0;
  if (positive + negative < 3) return std::nullopt;
  return here < 0 ? 1 : -1;
}

std::optional<int> winding_along(const Segment& s, SearchSpace space) noexcept {
  int winding = 0;
  std::array<std::uint32_t, bvh_depth_limit> stack;
  std::size_t size = 0;
  stack[size++] = 0;
  while (size > 0) {
    const std::uint32_t index = stack[--size];
    const BvhNode& node = space.bvh.nodes[index];
    if (!may_meet(s, node.box)) continue;
    if (!node.is_group()) {
      stack[size++] = space.bvh.right(index);
      stack[size++] = space.bvh.left(index);
      continue;
    }
    const TriangleGroup& group = space.triangles.groups[node.first_group];
    for (std::size_t lane = 0; lane < space.triangles.lanes(node.first_group); ++lane) {
      // A triangle of no area is met only where its neighbours' edges are.
      if (group.normal(lane) == Vec3{}) continue;
      const std::optional<int> c =
          crossing(s, {group.vertex(0, lane), group.vertex(1, lane), group.vertex(2, lane)});
      if (!c) return std::nullopt;
      winding += *c;
    }
  }
  return winding;
}

}  // namespace

int winding_by_crossings(const Vec3& p, SearchSpace space) noexcept {
  const Box& box = space.bvh.nodes[0].box;
  if (!contains(box, p)) return 0;
  const double far = 2 * diagonal_above(box);
  // Directions of no particular meaning, so that no plane of a made part holds them; their sizes make the end
  // point leave the box along x, y or z.
  for (int attempt = 0; attempt < 48; ++attempt) {
    const double a = 0.0123 + 0.0371 * attempt;
    const double b = 0.4567 - 0.0193 * attempt;
    const double sign = attempt % 2 == 0 ? 1 : -1;
    Vec3 d{sign, a, b};
    if (attempt % 3 == 1) d = {b, sign, a};
    if (attempt % 3 == 2) d = {a, b, sign};
    const Segment s{p, {p.x + far * d.x, p.y + far * d.y, p.z + far * d.z}};
    if (const std::optional<int> winding = winding_along(s, space)) return *winding;
  }
  assert(false && "48 directions that all meet an edge exactly");
  return 0;
}

}  // namespace cdfr
