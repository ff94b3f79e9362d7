/// Random numbers for the benches: the same in every run and on every machine.
#pragma once

#include <cmath>
#include <cstdint>

#include "cdfr/core/types.h"

namespace cdfr::bench {

class Random {
 public:
  explicit Random(std::uint64_t seed = 20010101) noexcept : state_(seed) {}

  /// In [0, 1): the high bits of a 64-bit linear congruence, mixed once.
  double unit() noexcept {
    state_ = state_ * 6364136223846793005U + 1442695040888963407U;
    return static_cast<double>((state_ ^ (state_ >> 29)) >> 11) * 0x1p-53;
  }
  Vec3 in(const Box& box) noexcept {
    const double x = unit(), y = unit(), z = unit();
    return {box.lo.x + (box.hi.x - box.lo.x) * x, box.lo.y + (box.hi.y - box.lo.y) * y,
            box.lo.z + (box.hi.z - box.lo.z) * z};
  }
  /// Evenly spread on the unit sphere.
  Vec3 direction() noexcept {
    for (;;) {
      const Vec3 p = in({{-1, -1, -1}, {1, 1, 1}});
      const double square = p.x * p.x + p.y * p.y + p.z * p.z;
      if (square > 1 || square < 0x1p-20) continue;
      const double length = std::sqrt(square);
      return {p.x / length, p.y / length, p.z / length};
    }
  }

 private:
  std::uint64_t state_;
};

}  // namespace cdfr::bench
