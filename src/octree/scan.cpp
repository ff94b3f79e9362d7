#include "octree/scan.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>
#include <utility>

// Highway compiles this file once for each instruction set and picks one when the program runs. SVE is left
// out: its vectors have no size at compile time; arm64 takes NEON.
#undef HWY_DISABLED_TARGETS
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "octree/scan.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace cdfr {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
/// Two groups at once where vectors are wide enough.
constexpr std::size_t pair_size = 2 * group_size;
using Tag = hn::CappedTag<float, pair_size>;
using Vector = hn::Vec<Tag>;
constexpr std::size_t lane_count = hn::MaxLanes(Tag());

struct Vector3 {
  Vector x, y, z;
};

HWY_INLINE Vector3 operator-(const Vector3& a, const Vector3& b) {
  return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}
HWY_INLINE Vector dot(const Vector3& a, const Vector3& b) {
  return hn::MulAdd(a.z, b.z, hn::MulAdd(a.y, b.y, hn::Mul(a.x, b.x)));
}
HWY_INLINE Vector3 cross(const Vector3& a, const Vector3& b) {
  return {hn::MulSub(a.y, b.z, hn::Mul(a.z, b.y)), hn::MulSub(a.z, b.x, hn::Mul(a.x, b.z)),
          hn::MulSub(a.x, b.y, hn::Mul(a.y, b.x))};
}
HWY_INLINE Vector sum_of_magnitudes(const Vector3& a) {
  return hn::Add(hn::Add(hn::Abs(a.x), hn::Abs(a.y)), hn::Abs(a.z));
}

/// Two groups of a list; the second may be the first again, without lanes of its own.
struct Pair {
  const ScanGroup* groups[2];
  float from[2][3];  ///< the point from each group's origin, in its unit
};

#if HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX3_DL
/// One row of both groups.
template <class T>
HWY_INLINE hn::Vec<hn::Rebind<T, Tag>> load_row(const T* first, const T* second, std::size_t) {
  const hn::Rebind<T, Tag> d;
  const hn::Half<decltype(d)> half;
  return hn::Combine(d, hn::Load(half, second), hn::Load(half, first));
}
HWY_INLINE Vector spread(float first, float second, std::size_t) {
  const Tag d;
  const hn::Half<Tag> half;
  return hn::Combine(d, hn::Set(half, second), hn::Set(half, first));
}
#else
/// One row's lanes from `lane` on, the first group's before the second's.
template <class T>
HWY_INLINE hn::Vec<hn::Rebind<T, Tag>> load_row(const T* first, const T* second, std::size_t lane) {
  return hn::Load(hn::Rebind<T, Tag>(), (lane < group_size ? first : second) + lane % group_size);
}
HWY_INLINE Vector spread(float first, float second, std::size_t lane) {
  return hn::Set(Tag(), lane < group_size ? first : second);
}
#endif

HWY_INLINE Vector whole(hn::Vec<hn::Rebind<std::int16_t, Tag>> v) {
  return hn::ConvertTo(Tag(), hn::PromoteTo(hn::Rebind<std::int32_t, Tag>(), v));
}

HWY_INLINE Vector3 vertex(const Pair& pair, int corner, std::size_t lane) {
  const auto &first = pair.groups[0]->vertices[corner], &second = pair.groups[1]->vertices[corner];
  return {whole(load_row(first[0], second[0], lane)), whole(load_row(first[1], second[1], lane)),
          whole(load_row(first[2], second[2], lane))};
}

HWY_INLINE Vector3 normal(const Pair& pair, std::size_t lane) {
  const auto &first = pair.groups[0]->normals, &second = pair.groups[1]->normals;
  return {load_row(first[0], second[0], lane), load_row(first[1], second[1], lane),
          load_row(first[2], second[2], lane)};
}

HWY_INLINE Vector3 point(const Pair& pair, std::size_t lane) {
  return {spread(pair.from[0][0], pair.from[1][0], lane), spread(pair.from[0][1], pair.from[1][1], lane),
          spread(pair.from[0][2], pair.from[1][2], lane)};
}

struct Beside {
  Vector squared;        ///< distance from the segment
  hn::Mask<Tag> inside;  ///< the projection is certainly on the inner side
};

/// One edge: e its direction, r the point minus its first vertex, n the triangle's unit normal.
HWY_INLINE Beside beside(const Vector3& e, const Vector3& r, const Vector3& n) {
  const Tag d;
  const Vector length = hn::Max(dot(e, e), hn::Set(d, std::numeric_limits<float>::min()));
  const Vector ratio = hn::Div(dot(r, e), length);
  const Vector t = hn::Max(hn::Min(ratio, hn::Set(d, 1.0F)), hn::Zero(d));
  const Vector3 o{hn::NegMulAdd(e.x, t, r.x), hn::NegMulAdd(e.y, t, r.y), hn::NegMulAdd(e.z, t, r.z)};
  const Vector doubt =
      hn::Mul(hn::Set(d, 16 * 0x1p-24F), hn::Mul(sum_of_magnitudes(e), sum_of_magnitudes(r)));
  return {dot(o, o), hn::Gt(dot(cross(e, r), n), doubt)};
}

/// Squared distances, in edges, to the triangles of as many lanes as the instruction set has, from `lane` on.
HWY_INLINE Vector estimated(const Pair& pair, std::size_t lane) {
  const Vector3 p = point(pair, lane), n = normal(pair, lane);
  const Vector3 a = vertex(pair, 0, lane), b = vertex(pair, 1, lane), c = vertex(pair, 2, lane);
  const Vector3 from_a = p - a;
  const Beside ab = beside(b - a, from_a, n);
  const Beside bc = beside(c - b, p - b, n);
  const Beside ca = beside(a - c, p - c, n);
  const Vector least = hn::Min(hn::Min(ab.squared, bc.squared), ca.squared);
  const auto inside = hn::And(hn::And(ab.inside, bc.inside), ca.inside);
  const Vector height = dot(from_a, n);
  const Vector unit = spread(pair.groups[0]->unit, pair.groups[1]->unit, lane);
  return hn::Mul(hn::IfThenElse(inside, hn::Mul(height, height), least), hn::Mul(unit, unit));
}

/// A scan under way.
class Scan {
 public:
  Scan(const ScanGroup* groups, const Vec3& point, Candidates& candidates)
      : groups_(groups), point_(point), found_(candidates) {
    found_.count = 0;
  }

  float upper() const { return upper_; }

  /// False if there is no room.
  bool take(const Entry& first, const Entry* second) {
    Pair pair;
    place(pair, 0, first);
    place(pair, 1, second != nullptr ? *second : first);
    const unsigned lanes = first.lanes() | (second != nullptr ? unsigned{second->lanes()} << group_size : 0U);
    const float reach = std::max(pair.groups[0]->reach(), pair.groups[1]->reach());
    admit(reach);
    HWY_ALIGN float squared[pair_size];
    unsigned close = 0;
    float least = std::numeric_limits<float>::infinity();
    const Tag d;
    for (std::size_t lane = 0; lane < pair_size; lane += lane_count) {
      const Vector estimate = estimated(pair, lane);
      hn::Store(estimate, d, squared + lane);
      const std::uint8_t bits[8] = {static_cast<std::uint8_t>(lanes >> lane),
                                    static_cast<std::uint8_t>(lanes >> lane >> 8)};
      const auto used = hn::LoadMaskBits(d, bits);
      const auto within = hn::And(used, hn::Le(estimate, hn::Set(d, reject_)));
      std::uint8_t kept[8] = {};
      hn::StoreMaskBits(d, within, kept);
      const unsigned mask = (kept[0] | unsigned{kept[1]} << 8) & ((1U << lane_count) - 1);
      if (mask == 0) continue;
      close |= mask << lane;
      least = std::min(least,
                       hn::GetLane(hn::MinOfLanes(d, hn::IfThenElse(within, estimate, hn::Set(d, least)))));
    }
    if (close == 0) return true;
    lower(least, reach);
    for (; close != 0; close &= close - 1) {
      const auto lane = static_cast<unsigned>(std::countr_zero(close));
      if (squared[lane] > reject_) continue;
      const std::uint32_t group = (lane < group_size ? first : *second).number();
      found_.slots[found_.count] = group * static_cast<std::uint32_t>(group_size) + lane % group_size;
      found_.squared[found_.count++] = squared[lane];
    }
    if (found_.count + pair_size <= found_.slots.size()) return true;
    thin();
    return found_.count + pair_size <= found_.slots.size();
  }

  void thin() {
    std::uint32_t kept = 0;
    for (std::uint32_t i = 0; i < found_.count; ++i) {
      if (found_.squared[i] > reject_) continue;
      found_.slots[kept] = found_.slots[i];
      found_.squared[kept++] = found_.squared[i];
    }
    found_.count = kept;
  }

 private:
  void place(Pair& pair, int which, const Entry& entry) const {
    const ScanGroup& group = groups_[entry.number()];
    pair.groups[which] = &group;
    const float units = 1 / group.unit;
    pair.from[which][0] = static_cast<float>(point_.x - group.origin[0]) * units;
    pair.from[which][1] = static_cast<float>(point_.y - group.origin[1]) * units;
    pair.from[which][2] = static_cast<float>(point_.z - group.origin[2]) * units;
  }

  /// Every group has its say in what it takes to be ruled out.
  void admit(float reach) {
    if (reach <= reach_) return;
    reach_ = reach;
    set_reject();
  }

  void lower(float squared, float reach) {
    const float upper = (std::sqrt(squared) + scan_share * reach + scan_floor) * (1 + 2 * scan_error);
    if (upper >= upper_) return;
    upper_ = upper;
    set_reject();
  }

  void set_reject() {
    const float beyond = (upper_ + scan_share * reach_ + scan_floor) * (1 + 2 * scan_error);
    reject_ = beyond * beyond;
  }

  const ScanGroup* groups_;
  Vec3 point_;
  Candidates& found_;
  float reach_ = 0;  ///< largest of the groups so far
  float upper_ = std::numeric_limits<float>::infinity();
  float reject_ = std::numeric_limits<float>::infinity();
};

/// Squared lower bounds on the entries of a part of a list, infinite up to the end of a vector.
void bound_entries(std::span<const Entry> part, const Located& leaf, float* squared) {
  const Tag d;
  const hn::RebindToUnsigned<Tag> u;
  const hn::RebindToSigned<Tag> i;
  const auto at = [&](double x) { return hn::Set(d, static_cast<float>(x)); };
  const auto byte = [&](auto words, auto shift) {
    return hn::ConvertTo(d, hn::ShiftRight<24>(hn::BitCast(i, hn::ShiftLeft<decltype(shift)::value>(words))));
  };
  const Vector x = at(leaf.offset.x), y = at(leaf.offset.y), z = at(leaf.offset.z);
  const Vector away = hn::MulAdd(z, z, hn::MulAdd(y, y, hn::Mul(x, x)));
  const Vector unit_below = at(leaf.size * leaf.size * EntryBound::unit_below);
  const Vector twice_size = at(2 * leaf.size), step = at(EntryBound::step), from_centre = at(leaf.from_centre);
  for (std::size_t first = 0; first < part.size(); first += lane_count) {
    const std::size_t left = part.size() - first;
    HWY_ALIGN std::uint32_t copied[3 * lane_count];
    const void* words = part.data() + first;
    if (left < lane_count) words = std::memcpy(copied, words, left * sizeof(Entry));
    hn::Vec<decltype(u)> place, packed, bound;
    hn::LoadInterleaved3(u, static_cast<const std::uint32_t*>(words), place, packed, bound);
    const Vector distance = hn::BitCast(d, hn::AndNot(hn::Set(u, 0xff), packed));
    const Vector slope = hn::MulAdd(
        byte(bound, std::integral_constant<int, 8>()), z,
        hn::MulAdd(byte(bound, std::integral_constant<int, 16>()), y,
                   hn::Mul(byte(bound, std::integral_constant<int, 24>()), x)));
    const Vector rise = hn::Mul(hn::Mul(hn::Add(distance, twice_size), step), slope);
    const auto below = hn::BitCast(i, hn::ShiftRight<24>(bound));
    const Vector lowered = hn::NegMulAdd(hn::ConvertTo(d, below), unit_below, hn::Add(away, rise));
    const Vector affine = hn::MulAdd(distance, distance, lowered);
    const auto has_bound = hn::RebindMask(d, hn::Ne(below, hn::Set(i, EntryBound::none)));
    const Vector outside = hn::Max(hn::Sub(distance, from_centre), hn::Zero(d));
    const Vector least = hn::Max(hn::Mul(outside, outside), hn::IfThenElseZero(has_bound, affine));
    hn::Store(hn::IfThenElse(hn::FirstN(d, left), least, hn::Inf(d)), d, squared + first);
  }
}

/// The first of the least of count values. Precondition: not all are infinite; so are those up to the end of
/// a vector.
std::uint32_t place_of_least(const float* values, std::size_t count) {
  const Tag d;
  Vector least = hn::Load(d, values);
  for (std::size_t i = lane_count; i < count; i += lane_count) least = hn::Min(least, hn::Load(d, values + i));
  least = hn::MinOfLanes(d, least);
  for (std::size_t i = 0;; i += lane_count) {
    const auto found = hn::FindFirstTrue(d, hn::Eq(hn::Load(d, values + i), least));
    if (found >= 0) return static_cast<std::uint32_t>(i) + static_cast<std::uint32_t>(found);
  }
}

void shorten_part(std::span<const Entry> part, const Located& leaf, Shortlist& shortlist) {
  constexpr float infinite = std::numeric_limits<float>::infinity();
  float* squared = shortlist.squared.data();
  bound_entries(part, leaf, squared);
  shortlist.first = shortlist.second = place_of_least(squared, part.size());
  if (part.size() == 1) return;
  const float least = std::exchange(squared[shortlist.first], infinite);
  shortlist.second = place_of_least(squared, part.size());
  squared[shortlist.first] = least;
}

void shorten_here(const ScanGroup* groups, const Located& leaf, Shortlist& shortlist) {
  const auto part = leaf.entries.first(std::min(leaf.entries.size(), Shortlist::most));
  if (part.empty()) return;
  shorten_part(part, leaf, shortlist);
  const auto call_for = [&](std::uint32_t i) {
    if (part[i].is_group()) prefetch(groups[part[i].number()]);
  };
  call_for(shortlist.first);
  if (shortlist.second != shortlist.first) call_for(shortlist.second);
}

/// The part of a list that a shortlist covers. False if the scan has to be given up.
bool scan_part(Scan& scan, std::span<const Entry> part, const ScanGroup* groups, Shortlist& shortlist) {
  constexpr float infinite = std::numeric_limits<float>::infinity();
  float* squared = shortlist.squared.data();
  const auto take = [&](const Entry& first, const Entry* second) {
    return first.is_group() && (second == nullptr || second->is_group()) && scan.take(first, second);
  };
  const auto limit = [&] { return scan.upper() * scan.upper(); };
  const auto [first, second] = std::pair(shortlist.first, shortlist.second);
  if (!(squared[first] <= limit())) return true;
  const bool two = first != second && squared[second] <= limit();
  if (!take(part[first], two ? &part[second] : nullptr)) return false;
  squared[first] = infinite;
  if (two) squared[second] = infinite;
  const Tag d;
  std::array<std::uint8_t, Shortlist::most> within;
  std::size_t count = 0;
  for (std::size_t i = 0; i < part.size(); i += lane_count) {
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(d, hn::Le(hn::Load(d, squared + i), hn::Set(d, limit())), bits);
    unsigned mask = (bits[0] | unsigned{bits[1]} << 8) & ((1U << lane_count) - 1);
    for (; mask != 0; mask &= mask - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(mask));
      within[count++] = static_cast<std::uint8_t>(i + lane);
      const Entry& entry = part[i + lane];
      if (entry.is_group()) prefetch(groups[entry.number()]);
    }
  }
  const Entry* held = nullptr;
  for (std::size_t k = 0; k < count; ++k) {
    if (squared[within[k]] > limit()) continue;
    const Entry& entry = part[within[k]];
    if (held == nullptr) {
      held = &entry;
    } else if (!take(*std::exchange(held, nullptr), &entry)) {
      return false;
    }
  }
  return held == nullptr || take(*held, nullptr);
}

bool scan_here(const ScanGroup* groups, const Vec3& point, const Located& leaf, Shortlist& shortlist,
               Candidates& candidates) {
  Scan scan(groups, point, candidates);
  std::span<const Entry> left = leaf.entries;
  while (!left.empty() && left[0].distance() - leaf.from_centre <= scan.upper()) {
    const auto part = left.first(std::min(left.size(), Shortlist::most));
    if (part.data() != leaf.entries.data()) shorten_part(part, leaf, shortlist);
    if (!scan_part(scan, part, groups, shortlist)) return false;
    left = left.subspan(part.size());
  }
  scan.thin();
  return true;
}

}  // namespace HWY_NAMESPACE
}  // namespace cdfr
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cdfr {

HWY_EXPORT(shorten_here);
HWY_EXPORT(scan_here);

void shorten(const ScanGroup* groups, const Located& leaf, Shortlist& shortlist) noexcept {
  HWY_DYNAMIC_DISPATCH(shorten_here)(groups, leaf, shortlist);
}

bool scan(const ScanGroup* groups, const Vec3& point, const Located& leaf, Shortlist& shortlist,
          Candidates& candidates) noexcept {
  return HWY_DYNAMIC_DISPATCH(scan_here)(groups, point, leaf, shortlist, candidates);
}

}  // namespace cdfr
#endif
