#include "octree/scan.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <utility>

#include "geometry/box_distance.h"

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

/// A scan under way. Nothing but its length branches on what it finds: nobody could foretell that.
class Scan {
 public:
  /// `at` is the point in edges from the lattice's origin.
  Scan(const ScanGroup* groups, const Vec3& at, Candidates& candidates)
      : groups_(groups), at_(at), found_(candidates) {
    found_.count = 0;
    found_.upper = std::numeric_limits<float>::infinity();
  }

  float upper() const { return found_.upper; }

  /// One group or two. False if there is no room.
  bool take(const Entry& first, const Entry* second) {
    const Entry& other = second != nullptr ? *second : first;
    Pair pair;
    place(pair, 0, first);
    place(pair, 1, other);
    const unsigned lanes = first.lanes() | (second != nullptr ? unsigned{second->lanes()} << group_size : 0U);
    reach_ = std::max({reach_, pair.groups[0]->reach(), pair.groups[1]->reach()});
    set_reject();
    const Tag d;
    const hn::RebindToUnsigned<Tag> u;
    const std::uint32_t slots[2] = {first.number() * std::uint32_t{group_size},
                                    other.number() * std::uint32_t{group_size}};
    for (std::size_t lane = 0; lane < pair_size; lane += lane_count) {
      const std::uint8_t bits[8] = {static_cast<std::uint8_t>(lanes >> lane),
                                    static_cast<std::uint8_t>(lanes >> lane >> 8)};
      const Vector squared = hn::IfThenElse(hn::LoadMaskBits(d, bits), estimated(pair, lane), hn::Inf(d));
      least_ = hn::Min(least_, squared);
      HWY_ALIGN std::uint32_t numbers[lane_count];
      for (std::size_t i = 0; i < lane_count; ++i) {
        numbers[i] = slots[(lane + i) / group_size] + static_cast<std::uint32_t>((lane + i) % group_size);
      }
      append(squared, hn::Load(u, numbers));
    }
    if (found_.count <= Candidates::most) return true;
    settle();
    return found_.count <= Candidates::most;
  }

  /// Brings the bounds up to date, and drops what they rule out.
  void settle() {
    const float least = hn::GetLane(hn::MinOfLanes(Tag(), least_));
    found_.upper = (std::sqrt(least) + scan_share * reach_ + scan_floor) * (1 + 2 * scan_error);
    set_reject();
    const std::uint32_t count = std::exchange(found_.count, 0);
    const Tag d;
    const hn::RebindToUnsigned<Tag> u;
    for (std::uint32_t i = 0; i < count; i += lane_count) {
      const Vector squared = hn::LoadU(d, found_.squared.data() + i);
      append(hn::IfThenElse(hn::FirstN(d, count - i), squared, hn::Inf(d)),
             hn::LoadU(u, found_.slots.data() + i));
    }
  }

 private:
  /// Every group has its say in what it takes to be ruled out. No bound is as large as the largest number,
  /// and no estimate of a lane that is not used as small.
  void set_reject() {
    const float beyond = (found_.upper + scan_share * reach_ + scan_floor) * (1 + 2 * scan_error);
    reject_ = std::min(beyond * beyond, std::numeric_limits<float>::max());
  }

  void place(Pair& pair, int which, const Entry& entry) const {
    const ScanGroup& group = groups_[entry.number()];
    pair.groups[which] = &group;
    const float units = 1 / group.unit;
    pair.from[which][0] = static_cast<float>(at_.x - group.origin[0]) * units;
    pair.from[which][1] = static_cast<float>(at_.y - group.origin[1]) * units;
    pair.from[which][2] = static_cast<float>(at_.z - group.origin[2]) * units;
  }

  /// What is finite and not ruled out. Writes up to a vector beyond the end.
  void append(Vector squared, hn::Vec<hn::RebindToUnsigned<Tag>> slots) {
    const Tag d;
    const hn::RebindToUnsigned<Tag> u;
    const auto kept = hn::Le(squared, hn::Set(d, reject_));
    hn::StoreU(hn::Compress(squared, kept), d, found_.squared.data() + found_.count);
    hn::StoreU(hn::Compress(slots, hn::RebindMask(u, kept)), u, found_.slots.data() + found_.count);
    found_.count += static_cast<std::uint32_t>(hn::CountTrue(d, kept));
  }

  const ScanGroup* groups_;
  Vec3 at_;
  Candidates& found_;
  Vector least_ = hn::Inf(Tag());
  float reach_ = 0;  ///< largest of the groups so far
  float reject_ = std::numeric_limits<float>::max();
};

/// The place of an entry is in the last bits of its bound, which this rounds down, so that the least bound
/// knows its entry. What lies beyond the end of the list, to the end of a vector, is not below `beyond_list`.
constexpr std::uint32_t place_mask = Shortlist::most - 1;
constexpr std::uint32_t beyond_list = 0x7f7fffffU & ~place_mask;

/// Squared lower bounds on the entries of a part of a list.
void bound_entries(std::span<const Entry> part, const Located& leaf, float* squared) {
  const Tag d;
  const hn::RebindToUnsigned<Tag> u;
  const hn::RebindToSigned<Tag> i;
  const auto at = [&](double x) { return hn::Set(d, static_cast<float>(x)); };
  const Vector x = at(leaf.offset.x), y = at(leaf.offset.y), z = at(leaf.offset.z);
  const Vector away = hn::MulAdd(z, z, hn::MulAdd(y, y, hn::Mul(x, x)));
  const Vector unit_below = at(leaf.size * leaf.size * EntryBound::unit_below);
  const Vector twice_size = at(2 * leaf.size), step = at(EntryBound::step),
               from_centre = at(leaf.from_centre);
  for (std::size_t first = 0; first < part.size(); first += lane_count) {
    const std::size_t left = part.size() - first;
    HWY_ALIGN std::uint32_t copied[3 * lane_count];
    const void* words = part.data() + first;
    if (left < lane_count) words = std::memcpy(copied, words, left * sizeof(Entry));
    hn::Vec<decltype(u)> place, packed, bound;
    hn::LoadInterleaved3(u, static_cast<const std::uint32_t*>(words), place, packed, bound);
    const Vector distance = hn::BitCast(d, hn::AndNot(hn::Set(u, 0xff), packed));
    const auto top_byte = [&](auto bytes) {
      return hn::ConvertTo(d, hn::ShiftRight<24>(hn::BitCast(i, bytes)));
    };
    const Vector slope = hn::MulAdd(
        top_byte(hn::ShiftLeft<8>(bound)), z,
        hn::MulAdd(top_byte(hn::ShiftLeft<16>(bound)), y, hn::Mul(top_byte(hn::ShiftLeft<24>(bound)), x)));
    const Vector rise = hn::Mul(hn::Mul(hn::Add(distance, twice_size), step), slope);
    const auto below = hn::BitCast(i, hn::ShiftRight<24>(bound));
    const Vector lowered = hn::NegMulAdd(hn::ConvertTo(d, below), unit_below, hn::Add(away, rise));
    const Vector affine = hn::MulAdd(distance, distance, lowered);
    const auto has_bound = hn::RebindMask(d, hn::Ne(below, hn::Set(i, EntryBound::none)));
    const Vector outside = hn::Max(hn::Sub(distance, from_centre), hn::Zero(d));
    const Vector least = hn::Max(hn::Mul(outside, outside), hn::IfThenElseZero(has_bound, affine));
    const auto listed = hn::RebindMask(u, hn::FirstN(d, left));
    const auto bits = hn::IfThenElse(listed, hn::BitCast(u, least), hn::Set(u, beyond_list));
    const auto places = hn::Iota(u, static_cast<std::uint32_t>(first));
    hn::Store(hn::Or(hn::AndNot(hn::Set(u, place_mask), bits), places), u,
              reinterpret_cast<std::uint32_t*>(squared) + first);
  }
}

/// The two least bounds.
void shorten_part(std::span<const Entry> part, const Located& leaf, Shortlist& shortlist) {
  const Tag d;
  const float* squared = shortlist.squared.data();
  bound_entries(part, leaf, shortlist.squared.data());
  Vector least = hn::Load(d, squared);
  Vector second = hn::Set(d, std::bit_cast<float>(beyond_list));
  for (std::size_t i = lane_count; i < part.size(); i += lane_count) {
    const Vector next = hn::Load(d, squared + i);
    second = hn::Min(second, hn::Max(least, next));
    least = hn::Min(least, next);
  }
  const Vector first = hn::MinOfLanes(d, least);
  second = hn::MinOfLanes(d, hn::Min(second, hn::IfThenElse(hn::Eq(least, first), second, least)));
  const auto key = [](Vector v) { return std::bit_cast<std::uint32_t>(hn::GetLane(v)); };
  shortlist.first = key(first) & place_mask;
  shortlist.second = key(second) < beyond_list ? key(second) & place_mask : shortlist.first;
}

void shorten_here(const ScanGroup* groups, const Located& leaf, Shortlist& shortlist) {
  const auto part = leaf.entries.first(std::min(leaf.entries.size(), Shortlist::most));
  if (part.empty()) return;
  shorten_part(part, leaf, shortlist);
  for (const std::uint32_t i : {shortlist.first, shortlist.second}) {
    if (part[i].is_group()) prefetch(groups[part[i].number()]);
  }
}

/// One bit for each entry whose bound is not above the limit.
std::uint64_t within(const Shortlist& shortlist, std::size_t count, float limit) {
  const Tag d;
  std::uint64_t entries = 0;
  for (std::size_t i = 0; i < count; i += lane_count) {
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(d, hn::Le(hn::Load(d, shortlist.squared.data() + i), hn::Set(d, limit)), bits);
    const unsigned lanes = (bits[0] | unsigned{bits[1]} << 8) & ((1U << lane_count) - 1);
    entries |= std::uint64_t{lanes} << i;
  }
  return entries;
}

/// Everything below a BVH node, nearer child first. False if there is no room.
bool scan_below(Scan& scan, const ScanSpace& space, const Vec3& p, std::uint32_t root) {
  struct Pending {
    std::uint32_t node;
    double squared;
  };
  const auto pending = [&](std::uint32_t node) {
    return Pending{node, squared_distance_below(p, space.bvh.nodes[node].box)};
  };
  double limit = HUGE_VAL;
  const auto set_limit = [&] {
    const double upper = double{scan.upper()} * space.lattice.edge;
    limit = upper * upper * (1 + 4 * unit_roundoff);
  };
  const auto take = [&](const Entry& first, const Entry* second) {
    if (!scan.take(first, second)) return false;
    scan.settle();
    set_limit();
    return true;
  };
  set_limit();
  std::optional<Entry> held;
  std::array<Pending, bvh_depth_limit> stack;
  std::size_t size = 0;
  for (Pending next = pending(root);;) {
    if (next.squared <= limit) {
      const BvhNode& node = space.bvh.nodes[next.node];
      if (!node.is_group()) {
        Pending near = pending(space.bvh.left(next.node)), far = pending(space.bvh.right(next.node));
        if (far.squared < near.squared) std::swap(near, far);
        stack[size++] = far;
        next = near;
        continue;
      }
      const Entry entry = Entry::of_group(node.first_group, 0, space.triangles.own_lanes(node.first_group));
      if (!held) {
        held = entry;
        prefetch(space.groups[entry.number()]);
      } else if (!take(*std::exchange(held, std::nullopt), &entry)) {
        return false;
      }
    }
    if (size == 0) return !held || take(*held, nullptr);
    next = stack[--size];
  }
}

/// One scan through a list.
class ListScan {
 public:
  ListScan(const ScanSpace& space, const Vec3& p, const Vec3& at, Candidates& candidates)
      : space_(space), p_(p), scan_(space.groups, at, candidates) {}

  /// False if there is no room.
  bool run(const Located& leaf, const Shortlist& shortlist) {
    std::span<const Entry> left = leaf.entries;
    for (bool begun = false; !left.empty() && left[0].distance() - leaf.from_centre <= scan_.upper();) {
      const auto part = left.first(std::min(left.size(), Shortlist::most));
      Shortlist next;
      if (begun) shorten_part(part, leaf, next);
      if (!run_part(part, begun ? next : shortlist)) return false;
      scan_.settle();
      begun = true;
      left = left.subspan(part.size());
    }
    return true;
  }

 private:
  /// What no bound of an entry exceeds, nor what lies beyond the list goes below.
  float limit() const {
    return std::min(scan_.upper() * scan_.upper(), std::bit_cast<float>(beyond_list - 1));
  }

  bool take(const Entry& first, const Entry* second) {
    return first.is_group() ? scan_.take(first, second) : scan_below(scan_, space_, p_, first.number());
  }

  bool run_part(std::span<const Entry> part, const Shortlist& shortlist) {
    const auto [first, second] = std::pair(shortlist.first, shortlist.second);
    if (!(shortlist.squared[first] <= limit())) return true;
    const bool two = first != second && part[first].is_group() && part[second].is_group() &&
                     shortlist.squared[second] <= limit();
    if (!take(part[first], two ? &part[second] : nullptr)) return false;
    scan_.settle();
    std::uint64_t left = within(shortlist, part.size(), limit());
    left &= ~(std::uint64_t{1} << first | std::uint64_t{two} << second);
    for (std::uint64_t ahead = left; ahead != 0; ahead &= ahead - 1) {
      const Entry& entry = part[static_cast<std::size_t>(std::countr_zero(ahead))];
      if (entry.is_group()) prefetch(space_.groups[entry.number()]);
    }
    const Entry* held = nullptr;
    for (; left != 0; left &= left - 1) {
      const Entry& entry = part[static_cast<std::size_t>(std::countr_zero(left))];
      if (held == nullptr && entry.is_group()) {
        held = &entry;
      } else if (!take(entry, entry.is_group() ? std::exchange(held, nullptr) : nullptr)) {
        return false;
      }
    }
    return held == nullptr || take(*held, nullptr);
  }

  const ScanSpace& space_;
  const Vec3& p_;
  Scan scan_;
};

bool scan_here(const ScanSpace& space, const Vec3& p, const Vec3& at, const Located& leaf,
               const Shortlist& shortlist, Candidates& candidates) {
  return ListScan(space, p, at, candidates).run(leaf, shortlist);
}

bool scan_all_here(const ScanSpace& space, const Vec3& p, Candidates& candidates) {
  const double scale = 1 / space.lattice.edge;  // exact: a power of two
  const Vec3& o = space.lattice.origin;
  Scan scan(space.groups, {(p.x - o.x) * scale, (p.y - o.y) * scale, (p.z - o.z) * scale}, candidates);
  return scan_below(scan, space, p, 0);
}

}  // namespace HWY_NAMESPACE
}  // namespace cdfr
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cdfr {

HWY_EXPORT(shorten_here);
HWY_EXPORT(scan_here);
HWY_EXPORT(scan_all_here);

namespace {

/// In edges from the brick's middle. At that distance single precision hides 2^-9 edges.
constexpr double farthest = 128;

}  // namespace

void shorten(const ScanGroup* groups, const Located& leaf, Shortlist& shortlist) noexcept {
  HWY_DYNAMIC_DISPATCH(shorten_here)(groups, leaf, shortlist);
}

void scan(const ScanSpace& space, const Vec3& p, const Vec3& at, const Located& leaf,
          const Shortlist& shortlist, Candidates& candidates) noexcept {
  candidates.complete = HWY_DYNAMIC_DISPATCH(scan_here)(space, p, at, leaf, shortlist, candidates);
}

void scan(const ScanSpace& space, const Vec3& p, Candidates& candidates) noexcept {
  const Box domain = space.lattice.domain();
  const Vec3 middle{(domain.lo.x + domain.hi.x) / 2, (domain.lo.y + domain.hi.y) / 2,
                    (domain.lo.z + domain.hi.z) / 2};
  candidates.upper = std::numeric_limits<float>::infinity();
  candidates.complete = distance_between(p, middle) <= farthest * space.lattice.edge &&
                        HWY_DYNAMIC_DISPATCH(scan_all_here)(space, p, candidates);
}

}  // namespace cdfr
#endif
