#include "geometry/place_estimate.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "geometry/offset.h"
#include "geometry/point_triangle.h"

// Compiled once for each instruction set, the same operations in the same order, never fused.
#undef HWY_DISABLED_TARGETS
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "geometry/place_estimate.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace cdfr {
namespace HWY_NAMESPACE {

#if HWY_MAX_BYTES >= 32

namespace hn = hwy::HWY_NAMESPACE;
using Tag = hn::CappedTag<double, 4>;
using Vector = hn::Vec<Tag>;

/// One lane an edge; the fourth repeats the third.
struct Vector3 {
  Vector x, y, z;
};

HWY_INLINE Vector3 minus(const Vector3& a, const Vector3& b) {
  return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}
HWY_INLINE Vector dot(const Vector3& a, const Vector3& b) {
  return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}
HWY_INLINE Vector sum_of_magnitudes(const Vector3& a) {
  return hn::Add(hn::Add(hn::Abs(a.x), hn::Abs(a.y)), hn::Abs(a.z));
}
HWY_INLINE Vector cross(Vector a, Vector b, Vector c, Vector d) {
  return hn::Sub(hn::Mul(a, b), hn::Mul(c, d));
}
HWY_INLINE Vector3 everywhere(double x, double y, double z) {
  return {hn::Set(Tag(), x), hn::Set(Tag(), y), hn::Set(Tag(), z)};
}
HWY_INLINE unsigned bits(hn::Mask<Tag> mask) {
  std::uint8_t stored[8] = {};
  hn::StoreMaskBits(Tag(), mask, stored);
  return stored[0] & 7U;
}

/// The corners of the triangle, each the first of an edge.
HWY_INLINE Vector3 corners(const TriangleShape& triangle) {
  const Tag d;
  const auto xyz = [&](int k) { return hn::MaskedLoad(hn::FirstN(d, 3), d, &triangle.vertices[k].x); };
  const Vector a = xyz(0), b = xyz(1), c = xyz(2);
  const Vector xz = hn::InterleaveLower(d, a, b), y = hn::InterleaveUpper(d, a, b);
  const Vector xz_c = hn::InterleaveLower(d, c, c), y_c = hn::InterleaveUpper(d, c, c);
  return {hn::ConcatLowerLower(d, xz_c, xz), hn::ConcatLowerLower(d, y_c, y),
          hn::ConcatUpperUpper(d, xz_c, xz)};
}

/// The next corner in each lane.
HWY_INLINE Vector3 turned(const Vector3& a) {
  alignas(32) static constexpr std::int64_t places[4] = {1, 2, 0, 0};
  const auto next = hn::SetTableIndices(Tag(), places);
  return {hn::TableLookupLanes(a.x, next), hn::TableLookupLanes(a.y, next), hn::TableLookupLanes(a.z, next)};
}

/// A bit for the place where the kernel finds each edge's foot.
HWY_INLINE hn::Vec<hn::RebindToSigned<Tag>> place_bits(Vector s, Vector rest, Vector doubt) {
  alignas(32) static constexpr std::int64_t on[4] = {1 << 1, 1 << 2, 1 << 3, 1 << 3};
  alignas(32) static constexpr std::int64_t at_first[4] = {1 << 4, 1 << 5, 1 << 6, 1 << 6};
  alignas(32) static constexpr std::int64_t at_second[4] = {1 << 5, 1 << 6, 1 << 4, 1 << 4};
  const hn::RebindToSigned<Tag> i;
  const auto as_whole = [&](hn::Mask<Tag> mask) { return hn::RebindMask(i, mask); };
  const Vector against = hn::Neg(doubt);
  const auto between = hn::And(hn::Gt(s, doubt), hn::Gt(rest, doubt));
  auto place = hn::IfThenElse(as_whole(between), hn::Load(i, on), hn::Set(i, 1 << unsure_place));
  place = hn::IfThenElse(as_whole(hn::Lt(s, against)), hn::Load(i, at_first), place);
  return hn::IfThenElse(as_whole(hn::Lt(rest, against)), hn::Load(i, at_second), place);
}

/// edge_by_edge below, in lanes. False where vectors are too short for it.
bool estimate_place_here(const Vec3& p, const TriangleShape& triangle, PlaceEstimate& estimate) {
  const Tag d;
  const Vector zero = hn::Zero(d);
  const Vec3 n = rounded(triangle.normal);
  const Vector3 v = corners(triangle);
  const Vector3 e = minus(turned(v), v), r = minus(everywhere(p.x, p.y, p.z), v);
  const Vector span = sum_of_magnitudes(e), size = hn::Add(span, sum_of_magnitudes(r));
  const Vector doubt = hn::Mul(hn::Mul(hn::Set(d, 16 * unit_roundoff), span), size);
  const Vector3 normal = everywhere(n.x, n.y, n.z);
  const Vector area =
      dot({cross(e.y, r.z, e.z, r.y), cross(e.z, r.x, e.x, r.z), cross(e.x, r.y, e.y, r.x)}, normal);
  const unsigned beside = bits(hn::Gt(area, doubt));
  if (beside == 7) {
    estimate.beside.fill(true);
    estimate.place = 0;
    return true;
  }
  for (unsigned k = 0; k < 3; ++k) estimate.beside[k] = (beside >> k & 1U) != 0;
  estimate.outside = n == Vec3{} || bits(hn::Lt(area, hn::Neg(doubt))) != 0;
  const Vector length = dot(e, e), s = dot(r, e), rest = hn::Sub(length, s);
  const Vector within = hn::IfThenElse(hn::Lt(s, length), hn::Div(s, length), hn::Set(d, 1));
  const Vector t = hn::IfThenElse(hn::Gt(s, zero), within, zero);
  const Vector3 o{hn::Sub(r.x, hn::Mul(t, e.x)), hn::Sub(r.y, hn::Mul(t, e.y)),
                  hn::Sub(r.z, hn::Mul(t, e.z))};
  const Vector squared = dot(o, o);
  const double least = std::sqrt(hn::GetLane(hn::MinOfLanes(d, squared)));
  const double bound = 64 * unit_roundoff * hn::GetLane(hn::MaxOfLanes(d, size));
  const double most = (least + 2 * bound) * (least + 2 * bound);
  const auto may_be_least = hn::Le(squared, hn::Set(d, most));
  for (unsigned k = 0, near = bits(may_be_least); k < 3; ++k)
    estimate.may_be_least[k] = (near >> k & 1U) != 0;
  const hn::RebindToSigned<Tag> i;
  alignas(32) std::int64_t agreeing[4];
  hn::Store(hn::IfThenElseZero(hn::RebindMask(i, may_be_least), place_bits(s, rest, doubt)), i, agreeing);
  const auto places = static_cast<unsigned>(agreeing[0] | agreeing[1] | agreeing[2]);
  if (estimate.outside && least > bound && (places & (places - 1)) == 0) {
    estimate.place = static_cast<TrianglePlace>(std::countr_zero(places));
  }
  return true;
}

#else

bool estimate_place_here(const Vec3&, const TriangleShape&, PlaceEstimate&) { return false; }

#endif

}  // namespace HWY_NAMESPACE
}  // namespace cdfr
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cdfr {

HWY_EXPORT(estimate_place_here);

namespace {

double dot(const Vec3& a, const Vec3& b) noexcept { return a.x * b.x + a.y * b.y + a.z * b.z; }

double sum_of_magnitudes(const Vec3& v) noexcept { return std::fabs(v.x) + std::fabs(v.y) + std::fabs(v.z); }

/// An edge from one corner on, and p from there.
struct Edge {
  Vec3 e, r;
  double size;   ///< |e|_1 + |r|_1: at least |p - v|_1 of either end
  double doubt;  ///< 16u |e|_1 size
};

Edge edge_of(const Vec3& p, const TriangleShape& triangle, int k) noexcept {
  const Vec3 e = minus(triangle.vertices[(k + 1) % 3], triangle.vertices[k]);
  const Vec3 r = minus(p, triangle.vertices[k]);
  const double length = sum_of_magnitudes(e);
  const double size = length + sum_of_magnitudes(r);
  return {e, r, size, 16 * unit_roundoff * length * size};
}

/// Twice the signed area that p's projection spans with the edge, positive inside. Products carry two
/// differences and one multiplication, the cross product one subtraction, the dot product one multiplication,
/// the normal's rounding and two sums: 8u of |e|_1 |r|_1; 16u covers second order. The size of either end in
/// the bound leaves room for the kernel's test, which asks for 2^-96 |e|_1 |r|_1 from one of them.
double area_beside(const Edge& edge, const Vec3& n) noexcept {
  const auto& [e, r, size, doubt] = edge;
  return (e.y * r.z - e.z * r.y) * n.x + (e.z * r.x - e.x * r.z) * n.y + (e.x * r.y - e.y * r.x) * n.z;
}

struct EdgeEstimate {
  double squared;
  int place;  ///< the edge or its end where the kernel certainly finds the edge's foot, or unsure_place
};

/// The root of `squared` is off by less than 26u R: the clamped parameter moves the foot by at most 17u R
/// along the edge, differences, products and the root add 9u R.
///
/// s = r.e and |e|^2 are off by 5u of |r|_1 |e|_1 and |e|_1^2 (two differences, one multiplication, two
/// sums), their difference by one rounding more. The kernel's, from either end, are off by far less than the
/// 10u that are left. So beyond 16u they tell to which end it clamps the foot, or that it does not.
EdgeEstimate estimate_edge(const Edge& edge, int k) noexcept {
  const auto& [e, r, size, doubt] = edge;
  const double length = dot(e, e);
  const double s = dot(r, e);
  const double ratio = s / length;
  const double t = s > 0 ? (s < length ? ratio : 1) : 0;
  const Vec3 o{r.x - t * e.x, r.y - t * e.y, r.z - t * e.z};
  int place = s > doubt && length - s > doubt ? 1 + k : unsure_place;
  if (s < -doubt) place = 4 + k;
  if (length - s < -doubt) place = 4 + (k + 1) % 3;
  return {dot(o, o), place};
}

/// Which edges may be closest, and the place in which all of those agree. The bound on a distance is stated
/// with the largest |r|_1 + |e|_1 >= R; one root serves all three. A distance above its bound exceeds 38u R,
/// far more than what the kernel may take for zero.
void compare(const std::array<EdgeEstimate, 3>& feet, double size, PlaceEstimate& estimate) noexcept {
  const double least = std::sqrt(std::min({feet[0].squared, feet[1].squared, feet[2].squared}));
  const double bound = 64 * unit_roundoff * size;
  const double most = (least + 2 * bound) * (least + 2 * bound);
  unsigned places = 0;  // one bit each
  for (int k = 0; k < 3; ++k) {
    estimate.may_be_least[k] = feet[k].squared <= most;
    places |= unsigned{estimate.may_be_least[k]} << feet[k].place;
  }
  if (estimate.outside && least > bound && std::has_single_bit(places)) {
    estimate.place = static_cast<TrianglePlace>(std::countr_zero(places));
  }
}

PlaceEstimate edge_by_edge(const Vec3& p, const TriangleShape& triangle) noexcept {
  PlaceEstimate estimate;
  const Vec3 n = rounded(triangle.normal);
  std::array<Edge, 3> edges;
  estimate.outside = n == Vec3{};
  for (int k = 0; k < 3; ++k) {
    edges[k] = edge_of(p, triangle, k);
    const double area = area_beside(edges[k], n);
    estimate.beside[k] = area > edges[k].doubt;
    estimate.outside |= area < -edges[k].doubt;
  }
  if (estimate.beside[0] && estimate.beside[1] && estimate.beside[2]) {
    estimate.place = 0;
    return estimate;
  }
  std::array<EdgeEstimate, 3> feet;
  for (int k = 0; k < 3; ++k) feet[k] = estimate_edge(edges[k], k);
  compare(feet, std::max({edges[0].size, edges[1].size, edges[2].size}), estimate);
  return estimate;
}

}  // namespace

PlaceEstimate estimate_place(const Vec3& p, const TriangleShape& triangle) noexcept {
  PlaceEstimate estimate;
  if (HWY_DYNAMIC_DISPATCH(estimate_place_here)(p, triangle, estimate)) return estimate;
  return edge_by_edge(p, triangle);
}

}  // namespace cdfr
#endif
