#include "geometry/feet.h"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "core/vector.h"
#include "geometry/double_double.h"

// As in triangle_group.cpp: compiled once for each instruction set, one order of operations, never fused. SVE
// is left out there and here.
#undef HWY_DISABLED_TARGETS
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "geometry/feet.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "geometry/double_double_lanes.inc"

HWY_BEFORE_NAMESPACE();
namespace cdfr {
namespace HWY_NAMESPACE {

HWY_INLINE Vector coordinate(const Vector3& p, const TriangleFrame::Axis& axis) {
  return times(axis.way[0], p.x) + times(axis.way[1], p.y) + times(axis.way[2], p.z) - constant(axis.start);
}

/// A point by an edge's frame.
struct Beside {
  Vector x, y;
  Vector beyond;   ///< x less what the edge covers of it
  Vector squared;  ///< distance from the edge in the triangle's plane
};

HWY_INLINE Beside beside(const Vector3& p, const TriangleFrame::Edge& edge) {
  Beside b;
  b.x = coordinate(p, edge.along);
  b.y = coordinate(p, edge.inwards);
  b.beyond = b.x - least_of(most_of(b.x, constant(0)), constant(edge.length));
  b.squared = b.beyond * b.beyond + b.y * b.y;
  return b;
}

/// A point by all of a triangle's frames.
struct Seen {
  Beside edges[3];
  Vector height, border, squared;
  Mask is_beside;
};

HWY_INLINE Seen seen(const Vector3& p, const TriangleFrame& t) {
  Seen s;
  for (int k = 0; k < 3; ++k) s.edges[k] = beside(p, t.edges[k]);
  s.height = coordinate(p, t.height);
  s.border = least_of(least_of(s.edges[0].squared, s.edges[1].squared), s.edges[2].squared);
  s.is_beside = least_of(least_of(s.edges[0].y, s.edges[1].y), s.edges[2].y) <= constant(t.doubt);
  s.squared = s.height * s.height + choose(s.is_beside, s.border, constant(0));
  return s;
}

HWY_INLINE Vector3 points_at(const RegionPoints& points, std::size_t first) {
  return {load(points.at[0] + first), load(points.at[1] + first), load(points.at[2] + first)};
}

void squared_distances_here(std::span<const TriangleFrame> frames, FrameNumbers numbers,
                            const RegionPoints& points, double* squared) {
  for (std::size_t first = 0; first < points.count; first += vector_lanes()) {
    const Vector3 p = points_at(points, first);
    Vector least = constant(std::numeric_limits<double>::infinity());
    for (const std::uint16_t number : numbers) least = least_of(least, seen(p, frames[number]).squared);
    store(least, squared + first);
  }
}

/// The offset in the plane and the place, by the closest edge.
struct Border {
  Vector3 offset;
  Vector place;
};

HWY_INLINE Border border(const Seen& s, const TriangleFrame& t) {
  Border best;
  for (int k = 0; k < 3; ++k) {
    const Beside& b = s.edges[k];
    const TriangleFrame::Edge& edge = t.edges[k];
    const auto component = [&](int axis) {
      return times(edge.along.way[axis], b.beyond) + times(edge.inwards.way[axis], b.y);
    };
    Vector place = choose(b.beyond < constant(0), constant(4 + k), constant(1 + k));
    place = choose(b.beyond > constant(0), constant(4 + (k + 1) % 3), place);
    const Border own{{component(0), component(1), component(2)}, place};
    if (k == 0) {
      best = own;
      continue;
    }
    const Mask is_best = b.squared <= s.border;
    best.offset = {choose(is_best, own.offset.x, best.offset.x), choose(is_best, own.offset.y, best.offset.y),
                   choose(is_best, own.offset.z, best.offset.z)};
    best.place = choose(is_best, own.place, best.place);
  }
  return best;
}

/// Of the vector's points: unit vectors for faces, offsets for the rest.
struct Closest {
  Vector squared, number, place;
  Vector3 way;
};

HWY_INLINE void meet(const Vector3& p, const TriangleFrame& t, double number, Closest& best) {
  const Vector zero = constant(0);
  const Seen s = seen(p, t);
  const Mask closer = s.squared < best.squared;
  if (!any(closer)) return;
  best.squared = least_of(best.squared, s.squared);
  best.number = choose(closer, constant(number), best.number);
  const Vector above = choose(s.height < zero, constant(-1), constant(1));
  Vector3 way{times(t.height.way[0], above), times(t.height.way[1], above), times(t.height.way[2], above)};
  Vector place = zero;
  if (any(closer & s.is_beside)) {
    const Border b = border(s, t);
    const auto own = [&](int axis, Vector in_plane, Vector face) {
      return choose(s.is_beside, times(t.height.way[axis], s.height) + in_plane, face);
    };
    way = {own(0, b.offset.x, way.x), own(1, b.offset.y, way.y), own(2, b.offset.z, way.z)};
    place = choose(s.is_beside, b.place, zero);
  }
  best.way = {choose(closer, way.x, best.way.x), choose(closer, way.y, best.way.y),
              choose(closer, way.z, best.way.z)};
  best.place = choose(closer, place, best.place);
}

/// Stores what belongs to the vector's points at `first`.
template <class Stored>
HWY_INLINE void store_closest(const Closest& best, std::size_t first, Stored& feet) {
  const Vector zero = constant(0), distance = root(best.squared);
  const Vector scale = choose(best.place > zero, constant(1) / distance, constant(1));
  store(distance, feet.distance + first);
  store(best.way.x * scale, feet.away[0] + first);
  store(best.way.y * scale, feet.away[1] + first);
  store(best.way.z * scale, feet.away[2] + first);
  store(best.place, feet.place + first);
}

HWY_INLINE Closest none_yet() {
  const Vector zero = constant(0);
  return {constant(std::numeric_limits<double>::infinity()), zero, zero, {zero, zero, zero}};
}

/// A vector may be longer than eight: its first half counts then.
struct alignas(64) VectorFeet {
  double distance[16], away[3][16], place[16];
};

void find_each_foot_here(std::span<const TriangleFrame> frames, FrameNumbers numbers,
                         const RegionPoints& points, EightFeet* feet) {
  VectorFeet stored;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    for (std::size_t first = 0; first < 8; first += vector_lanes()) {
      Closest best = none_yet();
      meet(points_at(points, first), frames[numbers[i]], 0, best);
      store_closest(best, first, stored);
    }
    std::copy_n(stored.distance, 8, feet[i].distance);
    for (int axis = 0; axis < 3; ++axis) std::copy_n(stored.away[axis], 8, feet[i].away[axis]);
    std::copy_n(stored.place, 8, feet[i].place);
  }
}

void find_feet_here(std::span<const TriangleFrame> frames, FrameNumbers numbers, const RegionPoints& points,
                    std::size_t start, Feet& feet) {
  const std::size_t count = std::min(Feet::most, points.count - start);
  for (std::size_t first = 0; first < count; first += vector_lanes()) {
    const Vector3 p = points_at(points, start + first);
    Closest best = none_yet();
    for (const std::uint16_t n : numbers) meet(p, frames[n], n, best);
    store_closest(best, first, feet);
    store(best.number, feet.number + first);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace cdfr
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cdfr {

HWY_EXPORT(squared_distances_here);
HWY_EXPORT(find_feet_here);
HWY_EXPORT(find_each_foot_here);

namespace {

using Eigen::Vector3d;

TriangleFrame::Axis axis_of(const Vector3d& way, const Vector3d& from) {
  return {{way[0], way[1], way[2]}, way.dot(from)};
}

}  // namespace

TriangleFrame triangle_frame(const TriangleShape& shape, const Vec3& middle, double radius) noexcept {
  Vector3d corners[3], edges[3];
  for (std::size_t k = 0; k < 3; ++k) corners[k] = to_eigen(shape.vertices[k]);
  for (std::size_t k = 0; k < 3; ++k) edges[k] = corners[(k + 1) % 3] - corners[k];
  Vector3d n = to_eigen(rounded(shape.normal));
  const bool has_area = !n.isZero(0);
  if (!has_area) {
    const Vector3d& longest = *std::max_element(edges, edges + 3, [](const Vector3d& a, const Vector3d& b) {
      return a.squaredNorm() < b.squaredNorm();
    });
    n = longest.squaredNorm() > 0 ? longest.unitOrthogonal() : Vector3d(Vector3d::UnitZ());
  }
  TriangleFrame frame;
  double farthest = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double length = edges[k].norm();
    const Vector3d along = length > 0 ? Vector3d(edges[k] / length) : n.unitOrthogonal();
    const Vector3d from = corners[k] - to_eigen(middle);
    farthest = std::max(farthest, from.norm());
    frame.edges[k] = {axis_of(along, from), axis_of(n.cross(along), from), length};
  }
  frame.height = axis_of(n, corners[0] - to_eigen(middle));
  frame.error = 24 * unit_roundoff * (farthest + radius);
  frame.doubt = has_area ? 13 * unit_roundoff * (farthest + radius) : std::numeric_limits<double>::infinity();
  return frame;
}

void squared_distances(std::span<const TriangleFrame> frames, FrameNumbers numbers,
                       const RegionPoints& points, double* squared) noexcept {
  HWY_DYNAMIC_DISPATCH(squared_distances_here)(frames, numbers, points, squared);
}

void find_feet(std::span<const TriangleFrame> frames, FrameNumbers numbers, const RegionPoints& points,
               std::size_t first, Feet& feet) noexcept {
  HWY_DYNAMIC_DISPATCH(find_feet_here)(frames, numbers, points, first, feet);
}

void find_each_foot(std::span<const TriangleFrame> frames, FrameNumbers numbers, const RegionPoints& points,
                    EightFeet* feet) noexcept {
  HWY_DYNAMIC_DISPATCH(find_each_foot_here)(frames, numbers, points, feet);
}

}  // namespace cdfr
#endif
