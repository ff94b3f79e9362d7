/// A lower bound on how far the triangles of a list's entry are, which follows the point through the leaf: it
/// sorts out most entries before any of their triangles is read.
///
/// Let C be the leaf's centre, s its edge, x = P - C, and T the triangles. f(P) = d(P,T)^2 - |x|^2 is concave
/// (influence.h), so an affine function that is nowhere above f at the corners of the leaf is nowhere above
/// it in the leaf. With the entry's own distance D from the centre the bound is
///     d(P,T)^2 >= D^2 + |x|^2 + (D + 2s) step slope.x - below s^2 / 128,     step = 2/127,
/// in few bits: `slope` is what the gradient of f is in those units, for feet are within D + 2s of the
/// centre. It is as tight as can be where the foot rests while P moves, and loses at most half of s^2 where
/// the foot moves along.
///
/// **Rounding.** `below` is rounded up, after `slope` was rounded. It also covers
///  - single precision where the bound is evaluated, u = 2^-24: |x|^2 <= 3/4 s^2 is off by 6u of itself (its
///  coordinates by u each), slope.x, at most 3/2 s in size after the division by 127, by 6u, the factor by
///  3u, and four sums by u of at most D^2 + 3 s (D + 2s) + 3 s^2 each. In all below 16u (D + 3s)^2;
///  - points outside the leaf by Lattice::grown, below 2^-48 s (leaf_index.h moves them): f and the bound
///  have gradients below 4 (D + 2s), so by less than 2^-45 (D + 3s)^2.
#pragma once

#include <array>
#include <cstdint>

namespace cdfr {

struct EntryBound {
  /// No bound but the distance from the centre.
  static constexpr std::uint8_t none = 255;
  static constexpr double step = 2.0 / 127;
  static constexpr double unit_below = 1.0 / 128;

  std::array<std::int8_t, 3> slope{};
  std::uint8_t below = none;

  friend bool operator==(const EntryBound&, const EntryBound&) = default;
};
static_assert(sizeof(EntryBound) == 4);

/// From lower bounds on the squared distances to the eight corners in child order, D and s in the same unit.
EntryBound entry_bound(const std::array<double, 8>& squared, double distance, double size) noexcept;

}  // namespace cdfr
