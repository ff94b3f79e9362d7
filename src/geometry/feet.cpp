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

#include "geometry/frame_lanes.inc"

HWY_BEFORE_NAMESPACE();
namespace cdfr {
namespace HWY_NAMESPACE {

/// Is the triangle of that place in the list farther from all points than those squared distances?
HWY_INLINE bool is_farther(const Vector3& p, const NearTriangles& near, std::size_t k, Vector squared) {
  if (near.supports.empty()) return false;
  const Vector least = hn::Max(minus(coordinate(p, near.supports[k]), constant(near.slack)), constant(0));
  return hn::AllTrue(Tag(), hn::Gt(times(least, least), squared));
}

void squared_distances_here(const NearTriangles& near, double most, const RegionPoints& points,
                            double* squared) {
  for (std::size_t first = 0; first < points.count; first += vector_lanes()) {
    const Vector3 p = points_at(points, first);
    Vector least = constant(most * most);
    for (std::size_t k = 0; k < near.numbers.size(); ++k) {
      if (is_farther(p, near, k, least)) continue;
      least = hn::Min(least, seen(p, near.frames[near.numbers[k]]).squared);
    }
    hn::Store(least, Tag(), squared + first);
  }
}

/// Of the vector's points.
struct Closest {
  Vector squared, number;
  Away away;
};

HWY_INLINE void meet(const Vector3& p, const TriangleFrame& t, double number, Closest& best) {
  const Seen s = seen(p, t);
  const Mask closer = hn::Lt(s.squared, best.squared);
  if (!any(closer)) return;
  const Away away = away_from(s, t);
  best.squared = hn::Min(best.squared, s.squared);
  best.number = choose(closer, constant(number), best.number);
  best.away = {choose(closer, away.way, best.away.way), choose(closer, away.place, best.away.place)};
}

/// Stores what belongs to the vector's points at `first`.
template <class Stored>
HWY_INLINE void store_closest(const Closest& best, std::size_t first, Stored& feet) {
  const Vector distance = hn::Sqrt(best.squared);
  const Vector3& way = best.away.way;
  const Vector scale =
      choose(hn::Gt(best.away.place, constant(0)), hn::Div(constant(1), distance), constant(1));
  hn::Store(distance, Tag(), feet.distance + first);
  hn::Store(times(way.x, scale), Tag(), feet.away[0] + first);
  hn::Store(times(way.y, scale), Tag(), feet.away[1] + first);
  hn::Store(times(way.z, scale), Tag(), feet.away[2] + first);
  hn::Store(best.away.place, Tag(), feet.place + first);
}

HWY_INLINE Closest none_yet() {
  const Vector zero = constant(0);
  return {constant(std::numeric_limits<double>::infinity()), zero, {{zero, zero, zero}, zero}};
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

void find_feet_here(const NearTriangles& near, const RegionPoints& points, std::size_t start, Feet& feet) {
  const std::size_t count = std::min(Feet::most, points.count - start);
  for (std::size_t first = 0; first < count; first += vector_lanes()) {
    const Vector3 p = points_at(points, start + first);
    Closest best = none_yet();
    for (std::size_t k = 0; k < near.numbers.size(); ++k) {
      if (is_farther(p, near, k, best.squared)) continue;
      meet(p, near.frames[near.numbers[k]], near.numbers[k], best);
    }
    store_closest(best, first, feet);
    hn::Store(best.number, Tag(), feet.number + first);
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

void squared_distances(const NearTriangles& near, const RegionPoints& points, double* squared,
                       double most) noexcept {
  HWY_DYNAMIC_DISPATCH(squared_distances_here)(near, most, points, squared);
}

void find_feet(const NearTriangles& near, const RegionPoints& points, std::size_t first,
               Feet& feet) noexcept {
  HWY_DYNAMIC_DISPATCH(find_feet_here)(near, points, first, feet);
}

void find_each_foot(std::span<const TriangleFrame> frames, FrameNumbers numbers, const RegionPoints& points,
                    EightFeet* feet) noexcept {
  HWY_DYNAMIC_DISPATCH(find_each_foot_here)(frames, numbers, points, feet);
}

}  // namespace cdfr
#endif
