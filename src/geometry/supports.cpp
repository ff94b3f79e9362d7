#include "geometry/supports.h"

#include <algorithm>
#include <array>
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

/// Of each cube's closest triangle.
struct Winner {
  Vector distance;
  Vector3 way;
  Mask covers;  ///< its face has the feet of the whole cube
};

/// The supports of the cubes from `first` on.
HWY_INLINE Winner find_all(std::span<const TriangleFrame> frames, FrameNumbers numbers, const Vector3& p,
                           std::size_t first, double half, Support* supports) {
  const Vector zero = constant(0);
  Winner winner{constant(std::numeric_limits<double>::infinity()), {zero, zero, zero}, hn::Gt(zero, zero)};
  for (std::size_t n = 0; n < numbers.size(); ++n) {
    const TriangleFrame& t = frames[numbers[n]];
    const Seen s = seen(p, t);
    const Away away = away_from(s, t);
    const Vector distance = hn::Sqrt(s.squared);
    Vector3 way = away.way;
    if (s.some_beside) {
      const Vector scale = choose(s.is_beside, hn::Div(constant(1), distance), constant(1));
      way = {times(way.x, scale), times(way.y, scale), times(way.z, scale)};
    }
    hn::Store(distance, Tag(), supports[n].distance + first);
    hn::Store(way.x, Tag(), supports[n].way[0] + first);
    hn::Store(way.y, Tag(), supports[n].way[1] + first);
    hn::Store(way.z, Tag(), supports[n].way[2] + first);
    const Mask closer = hn::Lt(distance, winner.distance);
    // A coordinate changes by sqrt(3) half within the cube.
    const Mask covers = hn::Gt(s.inmost, constant(t.doubt + 1.75 * half));
    winner.distance = hn::Min(distance, winner.distance);
    winner.way = choose(closer, way, winner.way);
    winner.covers = hn::Or(hn::And(closer, covers), hn::AndNot(closer, winner.covers));
  }
  return winner;
}

HWY_INLINE unsigned bits_of(Mask mask) {
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(Tag(), mask, bytes);
  return bytes[0] & ((1U << vector_lanes()) - 1);
}

void find_supports_here(std::span<const TriangleFrame> frames, FrameNumbers numbers,
                        const RegionPoints& centres, double half, double error, Support* supports) {
  for (std::size_t n = 0; n < numbers.size(); ++n) supports[n].is_near = 0;
  for (std::size_t first = 0; first < centres.count; first += vector_lanes()) {
    const Winner winner = find_all(frames, numbers, points_at(centres, first), first, half, supports);
    const Vector curved = hn::Div(constant(1.5 * half * half), winner.distance);
    // Farther than the cube reaches, so that all of it is on one side of the face.
    const Mask is_linear = hn::And(winner.covers, hn::Gt(winner.distance, constant(1.75 * half)));
    Vector margin = plus(choose(is_linear, constant(0), curved), constant(16 * error));
    margin = choose(hn::Lt(winner.distance, constant(half)),
                    constant(std::numeric_limits<double>::infinity()), margin);
    for (std::size_t n = 0; n < numbers.size(); ++n) {
      const auto apart = [&](int axis, Vector of_winner) {
        return hn::Abs(minus(of_winner, hn::Load(Tag(), supports[n].way[axis] + first)));
      };
      const Vector turn = plus(plus(apart(0, winner.way.x), apart(1, winner.way.y)), apart(2, winner.way.z));
      const Vector farther = minus(hn::Load(Tag(), supports[n].distance + first), winner.distance);
      const Mask is_far = hn::Gt(farther, plus(times(half, turn), margin));
      supports[n].is_near |= static_cast<std::uint8_t>((bits_of(hn::Not(is_far)) << first) & 0xffU);
    }
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
    double* const to[3] = {centres.at[0] + centres.count, centres.at[1] + centres.count,
                           centres.at[2] + centres.count};
    centres.count += hn::CompressStore(p.x, between, Tag(), to[0]);
    hn::CompressStore(p.y, between, Tag(), to[1]);
    hn::CompressStore(p.z, between, Tag(), to[2]);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace cdfr
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cdfr {

HWY_EXPORT(find_supports_here);
HWY_EXPORT(find_between_here);

void find_supports(std::span<const TriangleFrame> frames, FrameNumbers numbers, const RegionPoints& centres,
                   double half, double error, Support* supports) noexcept {
  HWY_DYNAMIC_DISPATCH(find_supports_here)(frames, numbers, centres, half, error, supports);
}

void find_between(std::span<const TriangleFrame::Axis> supports, const SmallCubes& cubes, double closest,
                  double lo, double hi, RegionPoints& centres) noexcept {
  HWY_DYNAMIC_DISPATCH(find_between_here)(supports, cubes, closest, lo, hi, centres);
}

}  // namespace cdfr
#endif
