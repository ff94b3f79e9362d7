#include "geometry/triangle_group.h"

// Highway compiles this file once for each instruction set and picks one when the program runs. Only plain
// additions, products, quotients and comparisons are used, in one order and never fused, so that every set
// gives the same bits: these estimates decide which lists are built.
// SVE is left out: its vectors have no size at compile time and cannot be members of a struct; arm64 takes NEON.
#undef HWY_DISABLED_TARGETS
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "geometry/triangle_group.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace cdfr {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Tag = hn::CappedTag<double, group_size>;
using Vector = hn::Vec<Tag>;

struct Vector3 {
  Vector x, y, z;
};

HWY_INLINE Vector3 operator-(const Vector3& a, const Vector3& b) {
  return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}
HWY_INLINE Vector3 operator*(const Vector3& a, Vector s) {
  return {hn::Mul(a.x, s), hn::Mul(a.y, s), hn::Mul(a.z, s)};
}
HWY_INLINE Vector dot(const Vector3& a, const Vector3& b) {
  return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}
HWY_INLINE Vector3 cross(const Vector3& a, const Vector3& b) {
  return {hn::Sub(hn::Mul(a.y, b.z), hn::Mul(a.z, b.y)), hn::Sub(hn::Mul(a.z, b.x), hn::Mul(a.x, b.z)),
          hn::Sub(hn::Mul(a.x, b.y), hn::Mul(a.y, b.x))};
}
HWY_INLINE Vector sum_of_magnitudes(const Vector3& a) {
  return hn::Add(hn::Add(hn::Abs(a.x), hn::Abs(a.y)), hn::Abs(a.z));
}
HWY_INLINE Vector3 choose(hn::Mask<Tag> mask, const Vector3& yes, const Vector3& no) {
  return {hn::IfThenElse(mask, yes.x, no.x), hn::IfThenElse(mask, yes.y, no.y),
          hn::IfThenElse(mask, yes.z, no.z)};
}

struct Beside {
  Vector3 offset;  ///< p minus the closest point of the segment
  Vector squared;
  hn::Mask<Tag> inside;  ///< the projection is certainly on the inner side
};

/// One edge: e its direction, r = p minus its first vertex, n the triangle's unit normal.
HWY_INLINE Beside beside(const Vector3& e, const Vector3& r, const Vector3& n) {
  const Tag d;
  const Vector zero = hn::Zero(d), one = hn::Set(d, 1.0);
  const Vector length = dot(e, e);
  const Vector ratio = hn::Div(dot(r, e), hn::IfThenElse(hn::Gt(length, zero), length, one));
  const Vector below = hn::IfThenElse(hn::Lt(ratio, one), ratio, one);
  const Vector t = hn::IfThenElse(hn::Gt(below, zero), below, zero);
  Beside result;
  result.offset = r - e * t;
  result.squared = dot(result.offset, result.offset);
  const Vector doubt =
      hn::Mul(hn::Set(d, 16 * unit_roundoff), hn::Mul(sum_of_magnitudes(e), sum_of_magnitudes(r)));
  result.inside = hn::Gt(dot(cross(e, r), n), doubt);
  return result;
}

struct Estimated {
  Vector3 offset;
  Vector squared;
};

HWY_INLINE Vector3 loaded(const double (&xyz)[3][group_size], std::size_t lane) {
  const Tag d;
  return {hn::Load(d, xyz[0] + lane), hn::Load(d, xyz[1] + lane), hn::Load(d, xyz[2] + lane)};
}

/// Offsets to the triangles of as many lanes as the instruction set has, from `lane` on.
HWY_INLINE Estimated estimated(const Vec3& point, const TriangleGroup& group, std::size_t lane) {
  const Tag d;
  const Vector3 p{hn::Set(d, point.x), hn::Set(d, point.y), hn::Set(d, point.z)};
  const Vector3 a = loaded(group.vertices[0], lane);
  const Vector3 b = loaded(group.vertices[1], lane);
  const Vector3 c = loaded(group.vertices[2], lane);
  const Vector3 n = loaded(group.normals, lane);
  const Vector3 from_a = p - a;
  const Beside ab = beside(b - a, from_a, n);
  const Beside bc = beside(c - b, p - b, n);
  const Beside ca = beside(a - c, p - c, n);
  const auto second = hn::Lt(bc.squared, ab.squared);
  Estimated best{choose(second, bc.offset, ab.offset), hn::IfThenElse(second, bc.squared, ab.squared)};
  const auto third = hn::Lt(ca.squared, best.squared);
  best = {choose(third, ca.offset, best.offset), hn::IfThenElse(third, ca.squared, best.squared)};
  const auto inside = hn::And(hn::And(ab.inside, bc.inside), ca.inside);
  const Vector height = dot(from_a, n);
  return {choose(inside, n * height, best.offset),
          hn::IfThenElse(inside, hn::Mul(height, height), best.squared)};
}

void estimate_squared_here(const Vec3& p, const TriangleGroup& group, GroupDistances& squared) {
  const Tag d;
  for (std::size_t lane = 0; lane < group_size; lane += hn::Lanes(d)) {
    hn::StoreU(estimated(p, group, lane).squared, d, squared.data() + lane);
  }
}

Vec3 estimate_closest_here(const Vec3& p, const TriangleGroup& group, std::size_t lane) {
  const Tag d;
  const std::size_t within = lane % hn::Lanes(d);
  const Vector3 offset = estimated(p, group, lane - within).offset;
  HWY_ALIGN double x[group_size], y[group_size], z[group_size];
  hn::Store(offset.x, d, x);
  hn::Store(offset.y, d, y);
  hn::Store(offset.z, d, z);
  return {p.x - x[within], p.y - y[within], p.z - z[within]};
}

}  // namespace HWY_NAMESPACE
}  // namespace cdfr
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cdfr {

HWY_EXPORT(estimate_squared_here);
HWY_EXPORT(estimate_closest_here);

void estimate_squared(const Vec3& p, const TriangleGroup& group, GroupDistances& squared) noexcept {
  HWY_DYNAMIC_DISPATCH(estimate_squared_here)(p, group, squared);
}

Vec3 estimate_closest(const Vec3& p, const TriangleGroup& group, std::size_t lane) noexcept {
  return HWY_DYNAMIC_DISPATCH(estimate_closest_here)(p, group, lane);
}

}  // namespace cdfr
#endif
