#include "geometry/supports.h"

#include <algorithm>
#include <bit>
#include <limits>

// As in feet.cpp.
#undef HWY_DISABLED_TARGETS
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "geometry/supports.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "geometry/frame_lanes.inc"

#ifndef CDFR_GEOMETRY_SUPPORTS_LATTICE
#define CDFR_GEOMETRY_SUPPORTS_LATTICE
namespace cdfr {
namespace {

constexpr std::size_t most_small = 64;

/// Places in Morton order, from 0; the first 8 are those of 2 a side.
struct alignas(64) MortonPlaces {
  double at[3][most_small];
};

constexpr MortonPlaces morton_places() {
  MortonPlaces places{};
  for (std::size_t i = 0; i < most_small; ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      places.at[axis][i] = static_cast<double>((i >> axis & 1U) + 2 * (i >> (axis + 3) & 1U));
  }
  return places;
}

constexpr MortonPlaces morton = morton_places();

}  // namespace
}  // namespace cdfr
#endif

HWY_BEFORE_NAMESPACE();
namespace cdfr {
namespace HWY_NAMESPACE {

HWY_INLINE unsigned bits_of(Mask mask) {
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(Tag(), mask, bytes);
  return bytes[0] & ((1U << vector_lanes()) - 1);
}

/// Of each cube, the closest triangle so far, and what keeps others out of the cube.
struct Winner {
  Vector distance;
  Vector3 way;
  Mask covers;    ///< its face has the feet of the whole cube
  Vector margin;  ///< 3 h^2/(2w) and rounding

  HWY_INLINE Winner()
      : distance(constant(std::numeric_limits<double>::infinity())),
        way{constant(0), constant(0), constant(0)},
        covers(hn::Gt(constant(0), constant(0))),
        margin(distance) {}

  HWY_INLINE void take(Mask closer, Vector d, const Vector3& w, Mask c, double half, double error) {
    distance = hn::Min(d, distance);
    way = choose(closer, w, way);
    covers = hn::Or(hn::And(closer, c), hn::AndNot(closer, covers));
    // Farther than the cube reaches, so that all of it is on one side of the face.
    const Mask is_linear = hn::And(covers, hn::Gt(distance, constant(1.75 * half)));
    const Vector curved = choose(is_linear, constant(0), hn::Div(constant(1.5 * half * half), distance));
    margin = choose(hn::Lt(distance, constant(half)), constant(std::numeric_limits<double>::infinity()),
                    plus(curved, constant(16 * error)));
  }

  /// Where it keeps the triangle that is behind a plane at that distance from the centres, across `w`, out of
  /// the cubes; `most` is what slope 1 demands.
  HWY_INLINE Mask beats(Vector d, const Vector3& w, double half, double most) const {
    const Vector turn =
        plus(plus(hn::Abs(minus(way.x, w.x)), hn::Abs(minus(way.y, w.y))), hn::Abs(minus(way.z, w.z)));
    return hn::Gt(minus(d, distance), hn::Min(plus(times(half, turn), margin), constant(most)));
  }
};

/// Where the triangle's support as seen from a larger cube tells that it is not needed.
HWY_INLINE Mask is_out(const Vector3& p, const NearTriangles& near, std::size_t n, const Winner& winner,
                       double half, double most) {
  if (near.supports.empty()) return hn::Gt(constant(0), constant(0));
  const TriangleFrame::Axis& axis = near.supports[n];
  const Vector3 way{constant(axis.way[0]), constant(axis.way[1]), constant(axis.way[2])};
  return winner.beats(coordinate(p, axis), way, half, most);
}

HWY_INLINE void find_support(const TriangleFrame& t, const Vector3& p, std::size_t first, double half,
                             double error, Winner& winner, Support& support) {
  const Seen s = seen(p, t);
  const Vector distance = hn::Sqrt(s.squared);
  Vector3 way = away_from(s, t).way;
  if (s.some_beside) {
    const Vector scale = choose(s.is_beside, hn::Div(constant(1), distance), constant(1));
    way = {times(way.x, scale), times(way.y, scale), times(way.z, scale)};
  }
  hn::Store(distance, Tag(), support.distance + first);
  hn::Store(way.x, Tag(), support.way[0] + first);
  hn::Store(way.y, Tag(), support.way[1] + first);
  hn::Store(way.z, Tag(), support.way[2] + first);
  const Mask closer = hn::Lt(distance, winner.distance);
  // A coordinate changes by sqrt(3) half within the cube.
  const Mask covers = hn::Gt(s.inmost, constant(t.doubt + 1.75 * half));
  if (any(closer)) winner.take(closer, distance, way, covers, half, error);
}

void find_supports_here(const NearTriangles& near, const RegionPoints& centres, double half, double error,
                        Supports& supports) {
  const std::size_t count = near.numbers.size();
  const double most = 3.5 * half + 16 * error;
  supports.half = half;
  std::fill_n(supports.near.begin(), count, std::uint8_t{0});
  for (std::size_t first = 0; first < centres.count; first += vector_lanes()) {
    const Vector3 p = points_at(centres, first);
    Winner winner;
    std::uint16_t met[Supports::most_numbers];
    std::size_t met_count = 0;
    for (std::size_t n = 0; n < count; ++n) {
      const Mask out = is_out(p, near, n, winner, half, most);
      if (hn::AllTrue(Tag(), out)) continue;
      met[met_count++] = static_cast<std::uint16_t>(n);
      supports.near[n] |= static_cast<std::uint8_t>(bits_of(hn::Not(out)) << first);
      find_support(near.frames[near.numbers[n]], p, first, half, error, winner, supports.of[n]);
    }
    for (std::size_t k = 0; k < met_count; ++k) {
      const Support& own = supports.of[met[k]];
      const Vector3 way{hn::Load(Tag(), own.way[0] + first), hn::Load(Tag(), own.way[1] + first),
                        hn::Load(Tag(), own.way[2] + first)};
      const Mask is_far = winner.beats(hn::Load(Tag(), own.distance + first), way, half, most);
      supports.near[met[k]] &= static_cast<std::uint8_t>(~(bits_of(is_far) << first));
    }
    hn::Store(winner.distance, Tag(), supports.least.data() + first);
  }
}

void find_between_here(std::span<const TriangleFrame::Axis> supports, const SmallCubes& cubes, double closest,
                       double lo, double hi, RegionPoints& centres) {
  const std::size_t all = cubes.along * cubes.along * cubes.along;
  const double to_first = 0.5 * static_cast<double>(cubes.along - 1);
  const double curved = cubes.size * cubes.size / (2 * closest);
  centres.count = 0;
  for (std::size_t first = 0; first < all; first += vector_lanes()) {
    const auto place = [&](int axis) {
      return minus(hn::Load(Tag(), morton.at[axis] + first), constant(to_first));
    };
    const Vector x = place(0), y = place(1), z = place(2);
    const Vector3 p{plus(constant(cubes.centre.x), times(cubes.size, x)),
                    plus(constant(cubes.centre.y), times(cubes.size, y)),
                    plus(constant(cubes.centre.z), times(cubes.size, z))};
    Vector least = constant(std::numeric_limits<double>::infinity());
    for (const TriangleFrame::Axis& support : supports) least = hn::Min(least, coordinate(p, support));
    const Vector square = plus(plus(times(x, x), times(y, y)), times(z, z));
    const Vector most = plus(least, times(curved, square));
    Mask between = hn::And(hn::Le(least, constant(hi)), hn::Ge(most, constant(lo)));
    between = hn::And(between, hn::FirstN(Tag(), all - first));
    unsigned left = bits_of(between);
    if (left == 0) continue;
    HWY_ALIGN double at[3][Support::most];
    hn::Store(p.x, Tag(), at[0]);
    hn::Store(p.y, Tag(), at[1]);
    hn::Store(p.z, Tag(), at[2]);
    for (; left != 0; left &= left - 1) {
      const auto i = static_cast<std::size_t>(std::countr_zero(left));
      centres.add({at[0][i], at[1][i], at[2][i]});
    }
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace cdfr
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cdfr {

HWY_EXPORT(find_supports_here);
HWY_EXPORT(find_between_here);

void find_supports(const NearTriangles& near, const RegionPoints& centres, double half, double error,
                   Supports& supports) noexcept {
  HWY_DYNAMIC_DISPATCH(find_supports_here)(near, centres, half, error, supports);
}

void find_between(std::span<const TriangleFrame::Axis> supports, const SmallCubes& cubes, double closest,
                  double lo, double hi, RegionPoints& centres) noexcept {
  HWY_DYNAMIC_DISPATCH(find_between_here)(supports, cubes, closest, lo, hi, centres);
}

}  // namespace cdfr
#endif
