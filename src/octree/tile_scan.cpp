#include "octree/tile_scan.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

// Highway compiles this file once for each instruction set and picks one when the program runs. SVE is left
// out: its vectors have no size at compile time; arm64 takes NEON.
#undef HWY_DISABLED_TARGETS
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "octree/tile_scan.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace cdfr {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
/// Points side by side: the eight corners of a box and its octants' eight centres fill the widest vector.
constexpr std::size_t probe_count = 16;
using Tag = hn::CappedTag<float, probe_count>;
using Vector = hn::Vec<Tag>;
constexpr std::size_t lane_count = hn::MaxLanes(Tag());

struct Vector3 {
  Vector x, y, z;
};

HWY_INLINE Vector set(float value) { return hn::Set(Tag(), value); }
HWY_INLINE Vector coordinate(const Vector3& p, const TileTriangle::Axis& axis) {
  const Vector x = hn::MulSub(p.x, set(axis.way[0]), set(axis.start));
  return hn::MulAdd(p.z, set(axis.way[2]), hn::MulAdd(p.y, set(axis.way[1]), x));
}

/// Features that a point's triangles are told to share; more than these may come twice.
constexpr std::size_t most_seen = 8;

/// A point by an edge's frame.
struct Beside {
  Vector x, y;
  Vector squared;  ///< distance from the edge in the triangle's plane
};

HWY_INLINE Beside beside(const Vector3& p, const TileTriangle::Edge& edge) {
  const Vector x = coordinate(p, edge.along), y = coordinate(p, edge.inwards);
  const Vector beyond = hn::Sub(x, hn::Min(hn::Max(x, hn::Zero(Tag())), set(edge.length)));
  return {x, y, hn::MulAdd(beyond, beyond, hn::Mul(y, y))};
}

HWY_INLINE Vector estimated(const Vector3& p, const TileTriangle& t) {
  const Beside ab = beside(p, t.edges[0]), bc = beside(p, t.edges[1]), ca = beside(p, t.edges[2]);
  const Vector border = hn::Min(hn::Min(ab.squared, bc.squared), ca.squared);
  const auto is_beside = hn::Le(hn::Min(hn::Min(ab.y, bc.y), ca.y), set(t.doubt));
  const Vector height = coordinate(p, t.height);
  return hn::MulAdd(height, height, hn::IfThenElseZero(is_beside, border));
}

HWY_INLINE unsigned bits_of(hn::Mask<Tag> mask) {
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(Tag(), mask, bytes);
  return (bytes[0] | unsigned{bytes[1]} << 8) & ((1U << lane_count) - 1);
}

/// (sqrt(U^2 + s^2 + m) + k reach + f) (1 + 2 k), squared: tile_scan.h has what it rules out.
HWY_INLINE Vector beyond(Vector squared, float reach, float m) {
  const float slack = tile_error * reach + scan_floor;
  const Vector upper = hn::MulAdd(hn::Sqrt(squared), set(1 + tile_error), set(slack));
  const Vector slip = hn::Mul(set(tile_slip), hn::Add(upper, set(reach)));
  const Vector root = hn::Sqrt(hn::MulAdd(upper, upper, hn::MulAdd(slip, slip, set(m))));
  const Vector threshold = hn::Mul(hn::Add(root, set(slack)), set(1 + 2 * tile_error));
  return hn::Mul(threshold, threshold);
}

struct Probes {
  HWY_ALIGN float at[3][probe_count];
};

Probes probes_of(const TileBox& box) {
  Probes probes;
  for (int axis = 0; axis < 3; ++axis) {
    const float lo = box.lo[axis], hi = box.hi[axis], quarter = (hi - lo) / 4;
    for (std::size_t c = 0; c < 8; ++c) {
      const bool high = (c >> axis & 1U) != 0;
      probes.at[axis][c] = high ? hi : lo;
      probes.at[axis][c + 8] = high ? hi - quarter : lo + quarter;
    }
  }
  return probes;
}

float spread_of(const TileBox& box, float reach) {
  float sum = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const float edge = box.hi[axis] - box.lo[axis] + 0x1p-22F * reach;
    sum += edge * edge;
  }
  return sum / 4 * (1 + tile_error);
}

constexpr std::size_t most_numbers = TileList::most;

std::size_t prune_here(const TileList& list, TileNumbers numbers, const TileBox& box, std::uint16_t* kept) {
  const Tag d;
  const Probes probes = probes_of(box);
  const float m = spread_of(box, list.reach);
  HWY_ALIGN float squared[most_numbers][probe_count];
  HWY_ALIGN float thresholds[probe_count][probe_count];
  HWY_ALIGN float closest[probe_count];
  for (std::size_t lane = 0; lane < probe_count; lane += lane_count) {
    const Vector3 p{hn::Load(d, probes.at[0] + lane), hn::Load(d, probes.at[1] + lane),
                    hn::Load(d, probes.at[2] + lane)};
    Vector least = set(std::numeric_limits<float>::infinity()), winner = hn::Zero(d);
    for (std::size_t n = 0; n < numbers.size(); ++n) {
      const Vector estimate = estimated(p, list.triangles[numbers[n]]);
      hn::Store(estimate, d, squared[n] + lane);
      const auto closer = hn::Lt(estimate, least);
      least = hn::Min(estimate, least);
      winner = hn::IfThenElse(closer, set(static_cast<float>(n)), winner);
    }
    hn::Store(winner, d, closest + lane);
  }
  std::uint64_t seen[most_numbers / 64] = {};
  std::size_t dominators = 0;
  for (const float number : closest) {
    const auto n = static_cast<std::size_t>(number);
    if ((seen[n / 64] >> n % 64 & 1U) != 0) continue;
    seen[n / 64] |= std::uint64_t{1} << n % 64;
    for (std::size_t lane = 0; lane < 8; lane += std::min<std::size_t>(lane_count, 8)) {
      hn::Store(beyond(hn::Load(d, squared[n] + lane), list.reach, m), d, thresholds[dominators] + lane);
    }
    ++dominators;
  }
  std::size_t count = 0;
  for (std::size_t n = 0; n < numbers.size(); ++n) {
    bool dropped = false;
    for (std::size_t k = 0; k < dominators && !dropped; ++k) {
      unsigned farther = 0;
      for (std::size_t lane = 0; lane < 8; lane += lane_count) {
        farther |= bits_of(hn::Gt(hn::Load(d, squared[n] + lane), hn::Load(d, thresholds[k] + lane))) << lane;
      }
      dropped = (farther & 0xffU) == 0xffU;
    }
    if (!dropped) kept[count++] = numbers[n];
  }
  return count;
}

/// Lets an edge say where its closest point is, if it may be the closest edge: its own place is `between`,
/// its ends' are at_from and at_to.
HWY_INLINE void join(const Beside& edge, const TileTriangle::Edge& e, float between, float at_from,
                     float at_to, Vector doubt, hn::Mask<Tag> may_be_closest, Vector& lowest,
                     Vector& highest) {
  const Vector rest = hn::Sub(set(e.length), edge.x);
  Vector place = set(unsure_place);
  place = hn::IfThenElse(hn::Gt(hn::Min(edge.x, rest), doubt), set(between), place);
  place = hn::IfThenElse(hn::Lt(edge.x, hn::Neg(doubt)), set(at_from), place);
  place = hn::IfThenElse(hn::Lt(rest, hn::Neg(doubt)), set(at_to), place);
  lowest = hn::IfThenElse(may_be_closest, hn::Min(lowest, place), lowest);
  highest = hn::IfThenElse(may_be_closest, hn::Max(highest, place), highest);
}

/// Where on the triangle the kernel certainly finds the foot, or unsure_place. No edge whose estimate exceeds
/// `most` is closest; `is_apart` where the distance is certainly not zero.
HWY_INLINE Vector sure_place(const Vector3& p, const TileTriangle& t, Vector most, hn::Mask<Tag> is_apart) {
  const Tag d;
  const Vector doubt = set(t.doubt), unsure = set(unsure_place);
  const Vector height = coordinate(p, t.height);
  Vector least_y = set(std::numeric_limits<float>::infinity()), lowest = unsure, highest = hn::Zero(d);
  for (int k = 0; k < 3; ++k) {
    const Beside edge = beside(p, t.edges[k]);
    const auto may_be_closest = hn::Le(hn::MulAdd(height, height, edge.squared), most);
    join(edge, t.edges[k], static_cast<float>(1 + k), static_cast<float>(4 + k),
         static_cast<float>(4 + (k + 1) % 3), doubt, may_be_closest, lowest, highest);
    least_y = hn::Min(least_y, edge.y);
  }
  const auto outside = hn::Lt(least_y, hn::Neg(doubt));
  const auto on_border = hn::And(hn::And(outside, is_apart), hn::Eq(lowest, highest));
  const Vector place = hn::IfThenElse(on_border, lowest, unsure);
  return hn::IfThenElse(hn::Gt(least_y, doubt), hn::Zero(d), place);
}

/// A name for the edge or vertex at that place of a triangle.
std::uint64_t feature_at(const TileList& list, std::size_t number, std::size_t place) {
  const TriangleRecord& record = list.store->records[list.slots[number]];
  return place < 4 ? std::uint64_t{record.edges[place - 1]} << 1
                   : std::uint64_t{record.vertices[place - 4]} << 1 | 1;
}

/// For one vector of points, what passed the bound.
struct Passed {
  std::uint64_t survivors = 0;         ///< bit k is set if survivor k did for any point
  unsigned lanes[TileFindings::most];  ///< for which points, if so
  HWY_ALIGN float places[TileFindings::most][lane_count];
};

/// Of the lane's triangles whose feet certainly are the same edge's or vertex's, one stays.
HWY_INLINE std::uint64_t distinct(const TileList& list, const TileFindings& found, const Passed& passed,
                                  std::size_t lane) {
  std::uint64_t kept = 0;
  std::uint64_t seen[most_seen];
  std::size_t seen_count = 0;
  for (std::uint64_t left = passed.survivors; left != 0; left &= left - 1) {
    const auto k = static_cast<std::size_t>(std::countr_zero(left));
    if ((passed.lanes[k] >> lane & 1U) == 0) continue;
    const auto place = static_cast<std::size_t>(passed.places[k][lane]);
    if (place != 0 && place != unsure_place) {
      const std::uint64_t feature = feature_at(list, found.survivors[k], place);
      if (std::find(seen, seen + seen_count, feature) != seen + seen_count) continue;
      if (seen_count < most_seen) seen[seen_count++] = feature;
    }
    kept |= std::uint64_t{1} << k;
  }
  return kept;
}

/// The lane's finding where it is not one number at a certain place.
HWY_INLINE void settle_lane(const TileList& list, const Passed& passed, std::size_t lane, std::size_t point,
                            TileFindings& found) {
  const std::uint64_t kept = distinct(list, found, passed, lane);
  found.kept[point] = kept;
  if ((kept & (kept - 1)) != 0) return;
  const int k = std::countr_zero(kept);
  found.number[point] = found.survivors[k];
  found.place[point] = passed.places[k][lane];
}

/// The points of one vector, `point` the first of them: estimates, then what passes the bound.
class VectorScan {
 public:
  HWY_INLINE VectorScan(const TileList& list, TileNumbers numbers, const Vector3& p) : list_(list), p_(p) {
    const Tag d;
    // In a register of its own: `this` is in memory.
    Vector least = set(std::numeric_limits<float>::infinity());
    for (std::size_t n = 0; n < numbers.size(); ++n) {
      const Vector estimate = estimated(p, list.triangles[numbers[n]]);
      hn::Store(estimate, d, squared_[n]);
      least = hn::Min(least, estimate);
    }
    least_ = least;
    reject_ = beyond(least, list.reach, 0);
  }

  /// `survivor_of` gives numbers their place among the survivors, or none. False if there is no room.
  HWY_INLINE bool find(TileNumbers numbers, std::uint8_t* survivor_of, std::size_t point,
                       TileFindings& found) {
    const Tag d;
    // Where the distance is about zero, the kernel asks for more than the place.
    const float slack = 2 * ((tile_slip + tile_error) * list_.reach + scan_floor);
    const auto is_apart = hn::Gt(least_, set(slack * slack));
    const Vector most = beyond(reject_, list_.reach, 0);
    Passed passed;
    auto some = hn::FirstN(d, 0), several = some;
    Vector number = hn::Zero(d), place = hn::Zero(d);
    for (std::size_t n = 0; n < numbers.size(); ++n) {
      const auto within = hn::Le(hn::Load(d, squared_[n]), reject_);
      if (hn::AllFalse(d, within)) continue;
      if (survivor_of[n] == no_survivor) {
        if (found.count == TileFindings::most) return false;
        found.survivors[found.count] = numbers[n];
        survivor_of[n] = static_cast<std::uint8_t>(found.count++);
      }
      const std::size_t k = survivor_of[n];
      const Vector sure = sure_place(p_, list_.triangles[numbers[n]], most, is_apart);
      passed.survivors |= std::uint64_t{1} << k;
      passed.lanes[k] = bits_of(within);
      hn::Store(sure, d, passed.places[k]);
      several = hn::Or(several, hn::And(some, within));
      some = hn::Or(some, within);
      number = hn::IfThenElse(within, set(static_cast<float>(numbers[n])), number);
      place = hn::IfThenElse(within, sure, place);
    }
    const Vector unsure = set(unsure_place);
    place = hn::IfThenElse(several, unsure, place);
    hn::Store(number, d, found.number + point);
    hn::Store(place, d, found.place + point);
    for (unsigned open = bits_of(hn::Eq(place, unsure)); open != 0; open &= open - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(open));
      settle_lane(list_, passed, lane, point + lane, found);
    }
    return true;
  }

  static constexpr std::uint8_t no_survivor = 255;

 private:
  const TileList& list_;
  const Vector3& p_;
  Vector least_, reject_;
  HWY_ALIGN float squared_[TileList::most][lane_count];
};

bool scan_tile_here(const TileList& list, TileNumbers numbers, const TilePoints& points,
                    TileFindings& found) {
  const Tag d;
  found.count = 0;
  std::uint8_t survivor_of[TileList::most];
  std::fill_n(survivor_of, numbers.size(), VectorScan::no_survivor);
  for (std::size_t first = 0; first < points.count; first += lane_count) {
    const Vector3 p{hn::Load(d, points.at[0] + first), hn::Load(d, points.at[1] + first),
                    hn::Load(d, points.at[2] + first)};
    if (!VectorScan(list, numbers, p).find(numbers, survivor_of, first, found)) return false;
  }
  return true;
}

}  // namespace HWY_NAMESPACE
}  // namespace cdfr
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cdfr {

HWY_EXPORT(prune_here);
HWY_EXPORT(scan_tile_here);

std::size_t prune(const TileList& list, TileNumbers numbers, const TileBox& box,
                  std::uint16_t* kept) noexcept {
  return HWY_DYNAMIC_DISPATCH(prune_here)(list, numbers, box, kept);
}

bool scan_tile(const TileList& list, TileNumbers numbers, const TilePoints& points,
               TileFindings& found) noexcept {
  return HWY_DYNAMIC_DISPATCH(scan_tile_here)(list, numbers, points, found);
}

}  // namespace cdfr
#endif
