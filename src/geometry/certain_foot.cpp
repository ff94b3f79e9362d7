#include "geometry/certain_foot.h"

#include <cmath>

#include "geometry/vertex_order.h"

// As in measured_lanes.cpp: compiled once for each instruction set, the operations of point_triangle.cpp in
// their order.
#undef HWY_DISABLED_TARGETS
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "geometry/certain_foot.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "geometry/double_double_lanes.inc"

HWY_BEFORE_NAMESPACE();
namespace cdfr {
namespace HWY_NAMESPACE {

#if HWY_MAX_BYTES >= 32 && HWY_NATIVE_FMA

using RowTag = hn::CappedTag<double, 4>;

/// x, y, z and a lane that nobody reads.
struct Row {
  hn::Vec<RowTag> lanes;
};

HWY_INLINE Row operator+(Row a, Row b) { return {hn::Add(a.lanes, b.lanes)}; }
HWY_INLINE Row operator-(Row a, Row b) { return {hn::Sub(a.lanes, b.lanes)}; }
HWY_INLINE Row operator*(Row a, Row b) { return {hn::Mul(a.lanes, b.lanes)}; }
HWY_INLINE Row operator-(Row a) { return {hn::Neg(a.lanes)}; }
HWY_INLINE Row fused_difference(Row a, Row b, Row c) { return {hn::MulSub(a.lanes, b.lanes, c.lanes)}; }

using DoubledRow = DoubledOf<Row>;
using DoubledOne = DoubledOf<double>;

HWY_INLINE Row row(const Vec3& v) {
  const RowTag d;
  return {hn::MaskedLoad(hn::FirstN(d, 3), d, &v.x)};
}

HWY_INLINE DoubledRow row(const DoubleDouble3& v) {
  const RowTag d;
  const auto xy = hn::LoadU(d, &v[0].hi), z = hn::MaskedLoad(hn::FirstN(d, 2), d, &v[2].hi);
  return {{hn::ConcatEven(d, z, xy)}, {hn::ConcatOdd(d, z, xy)}};
}

HWY_INLINE DoubledRow everywhere(const DoubledOne& a) {
  return {{hn::Set(RowTag(), a.hi)}, {hn::Set(RowTag(), a.lo)}};
}

struct Coordinates {
  HWY_ALIGN double hi[4];
  HWY_ALIGN double lo[4];

  explicit Coordinates(const DoubledRow& a) {
    hn::Store(a.hi.lanes, RowTag(), hi);
    hn::Store(a.lo.lanes, RowTag(), lo);
  }
  DoubledOne operator[](int axis) const { return {hi[axis], lo[axis]}; }
  double sum_of_magnitudes() const { return std::fabs(hi[0]) + std::fabs(hi[1]) + std::fabs(hi[2]); }
};

HWY_INLINE DoubledRow way(const Vec3& p, const Vec3& q) { return two_sum(row(p), -row(q)); }
HWY_INLINE DoubledOne dot(const DoubledRow& a, const DoubledRow& b) {
  const Coordinates terms(term(a, b));
  return sum(terms[0], terms[1], terms[2]);
}

HWY_INLINE DoubleDouble as_foot_has_it(const DoubledOne& a) { return {a.hi, a.lo}; }

HWY_INLINE void keep(const DoubledRow& offset, const DoubledOne& squared, Foot& foot) {
  const Coordinates kept(offset);
  for (int axis = 0; axis < 3; ++axis) foot.offset[axis] = as_foot_has_it(kept[axis]);
  foot.squared = as_foot_has_it(squared);
}

bool on_vertex(const Vec3& p, const Vec3& v, Foot& foot) {
  const DoubledRow offset = way(p, v);
  keep(offset, dot(offset, offset), foot);
  return true;
}

bool on_edge(const Vec3& p, const TriangleShape& triangle, int k, Foot& foot) {
  const int next = k < 2 ? k + 1 : 0;
  const bool reversed = precedes(triangle.vertices[next], triangle.vertices[k]);
  const Vec3& from = triangle.vertices[reversed ? next : k];
  const DoubledRow r = way(p, from);
  const DoubledRow e = way(triangle.vertices[reversed ? k : next], from);
  const DoubledOne t = dot(r, e) / dot(e, e);
  const DoubledRow offset = r - e * everywhere(t);
  const DoubledOne squared = dot(offset, offset);
  const double doubt = negligible_height * Coordinates(r).sum_of_magnitudes();
  if (squared.hi <= doubt * doubt) return false;
  keep(offset, squared, foot);
  foot.along = as_foot_has_it(t);
  return true;
}

bool on_face(const Vec3& p, const TriangleShape& triangle, Foot& foot) {
  const auto& v = triangle.vertices;
  const Vec3* base = precedes(v[1], v[0]) ? &v[1] : &v[0];
  base = precedes(v[2], *base) ? &v[2] : base;
  const DoubledRow r = way(p, *base), normal = row(triangle.normal);
  const DoubledOne height = dot(r, normal);
  if (std::fabs(height.hi) <= negligible_height * Coordinates(r).sum_of_magnitudes()) return false;
  keep(normal * everywhere(height), height * height, foot);
  foot.along = as_foot_has_it(height);
  return true;
}

bool measure_certain_here(TrianglePlace place, const Vec3& p, const TriangleShape& triangle, Foot& foot) {
  foot.place = place;
  if (place == 0) return on_face(p, triangle, foot);
  if (place < 4) return on_edge(p, triangle, place - 1, foot);
  return on_vertex(p, triangle.vertices[place - 4], foot);
}

#else

bool measure_certain_here(TrianglePlace, const Vec3&, const TriangleShape&, Foot&) { return false; }

#endif

}  // namespace HWY_NAMESPACE
}  // namespace cdfr
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cdfr {

HWY_EXPORT(measure_certain_here);

bool measure_certain(TrianglePlace place, const Vec3& p, const TriangleShape& triangle, Foot& foot) noexcept {
  return HWY_DYNAMIC_DISPATCH(measure_certain_here)(place, p, triangle, foot);
}

}  // namespace cdfr
#endif
