/// Squared distances from all that a cell's split asks about to the eight triangles of a group, at once.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "cdfr/core/types.h"
#include "geometry/triangle_group.h"

namespace cdfr {

/// Sample points of a cell: the 27 of the 3 x 3 x 3 lattice that its children's corners are, then the eight
/// centres of its children. x runs fastest.
inline constexpr std::size_t corner_samples = 27;
inline constexpr std::size_t sample_count = corner_samples + 8;

constexpr std::size_t corner_sample(std::size_t child, std::size_t corner) noexcept {
  const std::size_t x = (child & 1) + (corner & 1);
  const std::size_t y = (child >> 1 & 1) + (corner >> 1 & 1);
  const std::size_t z = (child >> 2 & 1) + (corner >> 2 & 1);
  return x + 3 * y + 9 * z;
}
constexpr std::size_t centre_sample(std::size_t child) noexcept { return corner_samples + child; }

/// Where they lie: on each axis at five places half a child's edge apart. Corners are at even places, centres
/// at odd ones.
struct Samples {
  std::array<std::array<double, 5>, 3> places;  ///< [axis][place], ascending

  Samples() = default;
  /// The cell's lowest corner and its children's edge.
  Samples(const Vec3& lo, double edge) noexcept;
  Vec3 point(std::size_t sample) const noexcept;
};

/// By sample, then by lane of the group.
struct alignas(64) SampleDistances {
  std::array<GroupDistances, sample_count> squared;
};

/// Below the squared distance d^2 by at most 256u M^2, and never above it, where u = 2^-53 and M is the
/// largest distance between a sample and a vertex of the triangle. May be negative.
///
/// The squared distance to an edge is |r|^2 - t (2 r.e - t |e|^2) with r = sample - vertex and the best t. As
/// samples lie on a lattice, |r|^2 and r.e are sums of one term an axis, and samples share the terms; so it
/// is with the height r.n over the plane and the side r.(n x e) of an edge. With |r| <= M, |e| <= 2M:
///  - |r|^2 is off by 5u M^2, r.e by 5u |r||e|, twice that by 20u M^2, |e|^2 by 20u M^2; the last four
///  operations
///    by 4u, 8u, 8u and 9u M^2. In all 74u M^2.
///  - t is off by 13u |r|/|e|, which costs the square of that times |e|^2: below u M^2.
///  - A height is off by 6u M, its square by 13u M^2. It counts where the projection is certainly inside:
///  sides
///    are off by 13u M |e|, the limit is 16u M |e|_1. Where the projection is inside by less than the two
///    together, 41u M, an edge is farther than the face by at most that in the plane, and its square by 41^2
///    u^2 M^2.
///  - Taking 128u M^2 off rounds by 10u M^2.
/// So 128u M^2 is enough, and no result is too small by more than twice that. No term can overflow or vanish:
/// coordinates are 0 or 2^-200 to 2^200 in size.
void squared_distances_below(const Samples& samples, const TriangleGroup& group,
                             SampleDistances& distances) noexcept;

/// The same for a box, never too large: three differences, products and two sums round by less than 6u
/// together.
std::array<double, sample_count> squared_distances_below(const Samples& samples, const Box& box) noexcept;

/// What is closest to each sample in each lane.
struct alignas(64) NearestOfSamples {
  std::array<GroupDistances, sample_count> squared;
  std::array<GroupDistances, sample_count> group;  ///< its number

  void clear() noexcept;
  void add(const SampleDistances& distances, std::uint32_t number) noexcept;
  /// Of all lanes; the first of equals. Precondition: something was added.
  std::uint32_t slot(std::size_t sample) const noexcept;
};

}  // namespace cdfr
