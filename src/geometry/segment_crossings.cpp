#include "geometry/segment_crossings.h"

#include <bit>
#include <cstdint>

#include "geometry/orientation.h"

// Highway compiles this file once for each instruction set and picks one when the program runs. What they
// leave open differs by rounding, and is decided exactly.
// SVE is left out: its vectors have no size at compile time and cannot be members of a struct; arm64 takes
// NEON.
#undef HWY_DISABLED_TARGETS
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "geometry/segment_crossings.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace cdfr {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Tag = hn::CappedTag<double, group_size>;
using Vector = hn::Vec<Tag>;
using Mask = hn::Mask<Tag>;

struct Vector3 {
  Vector x, y, z;
  Vector largest;  ///< of the magnitudes
};

HWY_INLINE Vector3 vector(Vector x, Vector y, Vector z) {
  return {x, y, z, hn::Max(hn::Max(hn::Abs(x), hn::Abs(y)), hn::Abs(z))};
}

struct Signs {
  Mask positive, negative;
};

/// Sign of det(a, b, c) where it is certain. Each component carries one rounding and the six products round
/// by less than 8u each, so 2^-46 of the product of the largest components covers them.
HWY_INLINE Signs certain_signs(const Vector3& a, const Vector3& b, const Vector3& c) {
  const Tag d;
  const Vector x = hn::Mul(a.x, hn::Sub(hn::Mul(b.y, c.z), hn::Mul(b.z, c.y)));
  const Vector y = hn::Mul(a.y, hn::Sub(hn::Mul(b.z, c.x), hn::Mul(b.x, c.z)));
  const Vector z = hn::Mul(a.z, hn::Sub(hn::Mul(b.x, c.y), hn::Mul(b.y, c.x)));
  const Vector determinant = hn::Add(hn::Add(x, y), z);
  const Vector bound = hn::Mul(hn::Set(d, 0x1p-46), hn::Mul(a.largest, hn::Mul(b.largest, c.largest)));
  return {hn::Gt(determinant, bound), hn::Lt(determinant, hn::Neg(bound))};
}

HWY_INLINE Vector3 corner_from(const Vec3& p, const double (&xyz)[3][group_size], std::size_t lane) {
  const Tag d;
  return vector(hn::Sub(hn::Load(d, xyz[0] + lane), hn::Set(d, p.x)),
                hn::Sub(hn::Load(d, xyz[1] + lane), hn::Set(d, p.y)),
                hn::Sub(hn::Load(d, xyz[2] + lane), hn::Set(d, p.z)));
}

HWY_INLINE unsigned bits_of(Mask mask) {
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(Tag(), mask, bits);
  return bits[0];
}

/// det(q - p, edges) and det(corners - end): see SegmentCrossings::add of one triangle.
HWY_INLINE void pass(const Vec3& p, const Vec3& q, const TriangleGroup& group, std::size_t lane,
                     Passages& passages) {
  const Tag d;
  const Vector3 way = vector(hn::Set(d, q.x - p.x), hn::Set(d, q.y - p.y), hn::Set(d, q.z - p.z));
  const auto corner = [&](const Vec3& from, std::size_t k) {
    return corner_from(from, group.vertices[k], lane);
  };
  const Vector3 a = corner(p, 0), b = corner(p, 1), c = corner(p, 2);
  const Signs ab = certain_signs(way, a, b), bc = certain_signs(way, b, c), ca = certain_signs(way, c, a);
  const Mask some_positive = hn::Or(hn::Or(ab.positive, bc.positive), ca.positive);
  const Mask some_negative = hn::Or(hn::Or(ab.negative, bc.negative), ca.negative);
  const Mask beside = hn::And(some_positive, some_negative);
  if (hn::AllTrue(d, beside)) return;
  const Signs behind = certain_signs(a, b, c);
  const Signs beyond = certain_signs(corner(q, 0), corner(q, 1), corner(q, 2));
  const Mask clear = hn::Or(
      beside, hn::Or(hn::And(behind.positive, beyond.positive), hn::And(behind.negative, beyond.negative)));
  const Mask out = hn::And(hn::And(hn::And(ab.positive, bc.positive), ca.positive),
                           hn::And(behind.positive, beyond.negative));
  const Mask in = hn::And(hn::And(hn::And(ab.negative, bc.negative), ca.negative),
                          hn::And(behind.negative, beyond.positive));
  passages.out |= bits_of(out) << lane;
  passages.in |= bits_of(in) << lane;
  passages.open |= bits_of(hn::Not(hn::Or(clear, hn::Or(out, in)))) << lane;
}

Passages passages_here(const Vec3& p, const Vec3& q, const TriangleGroup& group) {
  Passages passages;
  for (std::size_t lane = 0; lane < group_size; lane += hn::Lanes(Tag())) pass(p, q, group, lane, passages);
  return passages;
}

}  // namespace HWY_NAMESPACE
}  // namespace cdfr
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cdfr {

HWY_EXPORT(passages_here);

bool SegmentCrossings::add(const TriangleGroup& group, unsigned lanes) noexcept {
  const Passages passages = HWY_DYNAMIC_DISPATCH(passages_here)(p_, q_, group);
  total_ += std::popcount(passages.out & lanes) - std::popcount(passages.in & lanes);
  for (unsigned open = passages.open & lanes; open != 0; open &= open - 1) {
    const auto lane = static_cast<std::size_t>(std::countr_zero(open));
    if (group.normal(lane) == Vec3{}) continue;
    if (!add(group.vertex(0, lane), group.vertex(1, lane), group.vertex(2, lane))) return false;
  }
  return true;
}

/// The segment passes through the triangle if its ends are on different sides of the plane, and its line on
/// one side of all three edges.
bool SegmentCrossings::add(const Vec3& a, const Vec3& b, const Vec3& c) noexcept {
  const int from = orientation(a, b, c, p_), to = orientation(a, b, c, q_);
  if (from * to > 0) return true;
  const int ab = orientation(p_, a, b, q_), bc = orientation(p_, b, c, q_), ca = orientation(p_, c, a, q_);
  const auto any = [&](int side) { return ab == side || bc == side || ca == side; };
  if (any(1) && any(-1)) return true;
  if (from == 0 || to == 0 || any(0)) return false;
  total_ += to;
  return true;
}

}  // namespace cdfr
#endif
