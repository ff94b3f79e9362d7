#include "geometry/measured_lanes.h"

#include <cmath>

// As in triangle_group.cpp: compiled once for each instruction set, one order of operations, never fused. SVE
// is left out there and here.
#undef HWY_DISABLED_TARGETS
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "geometry/measured_lanes.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "geometry/double_double_lanes.inc"

HWY_BEFORE_NAMESPACE();
namespace cdfr {
namespace HWY_NAMESPACE {

HWY_INLINE Vector3 minus(const Vector3& a, const Vector3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
HWY_INLINE Vector dot(const Vector3& a, const Vector3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
HWY_INLINE Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
HWY_INLINE Vector sum_of_magnitudes(const Vector3& a) {
  return absolute(a.x) + absolute(a.y) + absolute(a.z);
}
HWY_INLINE Mask precedes(const Vector3& a, const Vector3& b) {
  return (a.x < b.x) | ((a.x == b.x) & ((a.y < b.y) | ((a.y == b.y) & (a.z < b.z))));
}

struct Pairs {
  Vector3 p, v[3], n;
};

HWY_INLINE Vector3 loaded(const double (&xyz)[3][lane_count], std::size_t lane) {
  return {load(xyz[0] + lane), load(xyz[1] + lane), load(xyz[2] + lane)};
}

/// An edge's estimates as in place_estimate.cpp, which derives the bounds.
struct EdgeEstimate {
  Vector squared, size, place;
  Mask beside, outside;
};

HWY_INLINE EdgeEstimate estimate_edge(const Pairs& pairs, int k) {
  const Vector zero = constant(0);
  const Vector3 e = minus(pairs.v[(k + 1) % 3], pairs.v[k]);
  const Vector3 r = minus(pairs.p, pairs.v[k]);
  const Vector span = sum_of_magnitudes(e);
  const Vector size = span + sum_of_magnitudes(r);
  const Vector doubt = constant(16 * unit_roundoff) * span * size;
  const Vector area = dot(cross(e, r), pairs.n);
  const Vector length = dot(e, e);
  const Vector s = dot(r, e);
  const Vector rest = length - s;
  const Vector t = choose(s > zero, choose(s < length, s / length, constant(1)), zero);
  const Vector3 o{r.x - t * e.x, r.y - t * e.y, r.z - t * e.z};
  Vector place = choose((s > doubt) & (rest > doubt), constant(1 + k), constant(unsure_place));
  place = choose(s < -doubt, constant(4 + k), place);
  place = choose(rest < -doubt, constant(4 + (k + 1) % 3), place);
  return {dot(o, o), size, place, area > doubt, area < -doubt};
}

/// The place in which all edges agree that may be least, or unsure_place.
HWY_INLINE Vector agreed_place(const EdgeEstimate& ab, const EdgeEstimate& bc, const EdgeEstimate& ca) {
  const Vector least = root(least_of(least_of(ab.squared, bc.squared), ca.squared));
  const Vector bound = constant(64 * unit_roundoff) * most_of(most_of(ab.size, bc.size), ca.size);
  const Vector reach = least + (bound + bound);
  const Vector most = reach * reach;
  Vector lowest = constant(unsure_place), highest = constant(0);
  for (const EdgeEstimate* edge : {&ab, &bc, &ca}) {
    const Mask may_be_least = edge->squared <= most;
    lowest = choose(may_be_least, least_of(lowest, edge->place), lowest);
    highest = choose(may_be_least, most_of(highest, edge->place), highest);
  }
  return choose((lowest == highest) & (least > bound), lowest, constant(unsure_place));
}

HWY_INLINE Vector estimate_place(const Pairs& pairs) {
  const EdgeEstimate ab = estimate_edge(pairs, 0), bc = estimate_edge(pairs, 1), ca = estimate_edge(pairs, 2);
  const Vector zero = constant(0);
  const Mask inside = ab.beside & bc.beside & ca.beside;
  if (all(inside)) return zero;
  const Mask no_area = (pairs.n.x == zero) & (pairs.n.y == zero) & (pairs.n.z == zero);
  const Mask outside = ab.outside | bc.outside | ca.outside | no_area;
  const Vector place = choose(outside, agreed_place(ab, bc, ca), constant(unsure_place));
  return choose(inside, zero, place);
}

struct Feet {
  Vector place;
  Doubled squared, along;
  Doubled3 offset;
};

/// point_triangle.cpp's on_edge and on_vertex, where the estimate has settled what they test.
HWY_INLINE void measure_borders(const Pairs& pairs, Mask on_edge, Feet& feet) {
  const auto at = [&](int k) { return (feet.place == constant(1 + k)) | (feet.place == constant(4 + k)); };
  const auto& v = pairs.v;
  const Mask second = at(1), third = at(2);
  const Vector3 own = choose(third, v[2], choose(second, v[1], v[0]));
  const Vector3 next = choose(third, v[0], choose(second, v[2], v[1]));
  const Mask reversed = on_edge & precedes(next, own);
  const Vector3 from = choose(reversed, next, own);
  const Doubled3 r = difference(pairs.p, from);
  feet.offset = r;
  if (any(on_edge)) {
    const Doubled3 e = difference(choose(reversed, own, next), from);
    const Doubled t = dot(r, e) / dot(e, e);
    feet.offset = choose(on_edge, {r.x - e.x * t, r.y - e.y * t, r.z - e.z * t}, r);
    feet.along = choose(on_edge, t, feet.along);
  }
  feet.squared = dot(feet.offset, feet.offset);
}

/// on_face, where the height is more than rounding.
HWY_INLINE void measure_faces(const Pairs& pairs, const Vector3& normal_rest, Mask on_face, Feet& feet) {
  const auto& v = pairs.v;
  const Vector3 first = choose(precedes(v[1], v[0]), v[1], v[0]);
  const Doubled3 r = difference(pairs.p, choose(precedes(v[2], first), v[2], first));
  const Doubled3 normal{{pairs.n.x, normal_rest.x}, {pairs.n.y, normal_rest.y}, {pairs.n.z, normal_rest.z}};
  const Doubled height = dot(r, normal);
  const Vector doubt = constant(negligible_height) * sum_of_magnitudes({r.x.hi, r.y.hi, r.z.hi});
  const Mask doubtful = on_face & (absolute(height.hi) <= doubt);
  feet.place = choose(doubtful, constant(unsure_place), feet.place);
  feet.along = choose(on_face, height, feet.along);
  feet.squared = choose(on_face, height * height, feet.squared);
}

HWY_INLINE void keep(const Feet& feet, std::size_t lane, MeasuredLanes& measured) {
  store(square_root(feet.squared), measured.distance + lane);
  store(feet.squared.hi, measured.squared + lane);
  store(feet.squared.lo, measured.squared_rest + lane);
  store(feet.along.hi, measured.along + lane);
  store(feet.along.lo, measured.along_rest + lane);
  const Doubled* offset[3] = {&feet.offset.x, &feet.offset.y, &feet.offset.z};
  for (int axis = 0; axis < 3; ++axis) {
    store(offset[axis]->hi, measured.offset[axis] + lane);
    store(offset[axis]->lo, measured.offset_rest[axis] + lane);
  }
  HWY_ALIGN double places[lane_count];
  store(feet.place, places + lane);
  for (std::size_t i = lane; i < lane + vector_lanes(); ++i) {
    measured.place[i] = static_cast<TrianglePlace>(places[i]);
  }
}

void measure_here(const PairLanes& lanes, MeasuredLanes& measured) {
  for (std::size_t lane = 0; lane < lane_count; lane += vector_lanes()) {
    const Pairs pairs{
        loaded(lanes.point, lane),
        {loaded(lanes.vertices[0], lane), loaded(lanes.vertices[1], lane), loaded(lanes.vertices[2], lane)},
        loaded(lanes.normal, lane)};
    const Vector zero = constant(0);
    const Doubled none{zero, zero};
    Feet feet{estimate_place(pairs), none, none, {none, none, none}};
    const Mask on_face = feet.place == zero;
    const Mask on_edge = (feet.place > zero) & (feet.place < constant(4));
    if (!all(on_face)) measure_borders(pairs, on_edge, feet);
    if (any(on_face)) measure_faces(pairs, loaded(lanes.normal_rest, lane), on_face, feet);
    keep(feet, lane, measured);
  }
}

HWY_INLINE Vector3 spread(const Vec3& v) { return {constant(v.x), constant(v.y), constant(v.z)}; }

void measure_at_here(const TriangleShape& triangle, TrianglePlace place, const PointLanes& points,
                     MeasuredLanes& measured) {
  const DoubleDouble3& n = triangle.normal;
  const Vector zero = constant(0);
  const Doubled none{zero, zero};
  const Vector at = constant(place);
  for (std::size_t lane = 0; lane < lane_count; lane += vector_lanes()) {
    const Pairs pairs{
        loaded(points.at, lane),
        {spread(triangle.vertices[0]), spread(triangle.vertices[1]), spread(triangle.vertices[2])},
        spread(rounded(n))};
    Feet feet{at, none, none, {none, none, none}};
    if (place == 0) {
      measure_faces(pairs, spread({n[0].lo, n[1].lo, n[2].lo}), at == zero, feet);
    } else {
      measure_borders(pairs, at < constant(4), feet);
    }
    keep(feet, lane, measured);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace cdfr
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cdfr {

HWY_EXPORT(measure_here);
HWY_EXPORT(measure_at_here);

namespace {

void keep(const Foot& foot, std::size_t lane, MeasuredLanes& measured) noexcept {
  measured.distance[lane] = square_root(foot.squared);
  measured.squared[lane] = foot.squared.hi;
  measured.squared_rest[lane] = foot.squared.lo;
  measured.along[lane] = foot.along.hi;
  measured.along_rest[lane] = foot.along.lo;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    measured.offset[axis][lane] = foot.offset[axis].hi;
    measured.offset_rest[axis][lane] = foot.offset[axis].lo;
  }
  measured.place[lane] = foot.place;
}

}  // namespace

void PairLanes::set(std::size_t lane, const Vec3& p, const TriangleShape& triangle) noexcept {
  const auto put = [lane](double(&xyz)[3][lane_count], const Vec3& v) {
    xyz[0][lane] = v.x;
    xyz[1][lane] = v.y;
    xyz[2][lane] = v.z;
  };
  put(point, p);
  for (std::size_t corner = 0; corner < 3; ++corner) put(vertices[corner], triangle.vertices[corner]);
  const DoubleDouble3& n = triangle.normal;
  put(normal, {n[0].hi, n[1].hi, n[2].hi});
  put(normal_rest, {n[0].lo, n[1].lo, n[2].lo});
}

TriangleShape PairLanes::triangle(std::size_t lane) const noexcept {
  TriangleShape shape;
  for (std::size_t corner = 0; corner < 3; ++corner) {
    shape.vertices[corner] = {vertices[corner][0][lane], vertices[corner][1][lane],
                              vertices[corner][2][lane]};
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    shape.normal[axis] = {normal[axis][lane], normal_rest[axis][lane]};
  }
  return shape;
}

Foot MeasuredLanes::foot(const TriangleShape& triangle, std::size_t lane) const noexcept {
  Foot foot;
  foot.squared = {squared[lane], squared_rest[lane]};
  foot.along = {along[lane], along_rest[lane]};
  foot.place = place[lane];
  if (foot.place == 0) {
    foot.offset = scaled(triangle.normal, foot.along);
  } else {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      foot.offset[axis] = {offset[axis][lane], offset_rest[axis][lane]};
    }
  }
  return foot;
}

void measure(const PairLanes& pairs, MeasuredLanes& measured) noexcept {
  HWY_DYNAMIC_DISPATCH(measure_here)(pairs, measured);
  for (std::size_t lane = 0; lane < lane_count; ++lane) {
    if (measured.place[lane] != unsure_place) continue;
    keep(measure(pairs.p(lane), pairs.triangle(lane)), lane, measured);
  }
}

void measure_at(const TriangleShape& triangle, TrianglePlace place, const PointLanes& points,
                MeasuredLanes& measured) noexcept {
  HWY_DYNAMIC_DISPATCH(measure_at_here)(triangle, place, points, measured);
  for (std::size_t lane = 0; lane < lane_count; ++lane) {
    if (measured.place[lane] != place) keep(measure(points.p(lane), triangle), lane, measured);
  }
}

}  // namespace cdfr
#endif
