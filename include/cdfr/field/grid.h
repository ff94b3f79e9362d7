/// A regular lattice of sample points.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "cdfr/core/types.h"

namespace cdfr {

/// Samples are numbered with x fastest: (i, j, k) is number (k * size[1] + j) * size[0] + i. Spacings may
/// differ, and be zero or negative.
struct Grid {
  Vec3 origin;
  Vec3 spacing{1, 1, 1};
  std::array<std::uint32_t, 3> size{};
  /// Where counting begins: a part of a grid, a slab say, has the very points of the whole.
  std::array<std::uint32_t, 3> first{};

  std::size_t count() const noexcept { return std::size_t{size[0]} * size[1] * size[2]; }
  /// Each coordinate is origin + spacing * (first + index): the product rounded to double, then the sum.
  Vec3 point(std::uint32_t i, std::uint32_t j, std::uint32_t k) const noexcept {
    const auto at = [](double from, double step, double start, double index) noexcept {
      return from + step * (start + index);
    };
    return {at(origin.x, spacing.x, first[0], i), at(origin.y, spacing.y, first[1], j),
            at(origin.z, spacing.z, first[2], k)};
  }
};

}  // namespace cdfr
