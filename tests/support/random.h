/// A small generator whose numbers are the same everywhere, and points drawn with it.
#pragma once

#include <algorithm>
#include <cstdint>

#include "cdfr/core/types.h"

namespace cdfr::test {

class Random {
 public:
  explicit Random(std::uint64_t seed) noexcept : state_(seed) {}

  /// splitmix64 (Steele, Lea, Flood 2014).
  std::uint64_t bits() noexcept {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15U);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31);
  }
  std::uint64_t below(std::uint64_t n) noexcept { return bits() % n; }
  /// In [lo, hi).
  double between(double lo, double hi) noexcept {
    return lo + (hi - lo) * (static_cast<double>(bits() >> 11) * 0x1p-53);
  }
  Vec3 in(const Box& box) noexcept {
    return {between(box.lo.x, box.hi.x), between(box.lo.y, box.hi.y), between(box.lo.z, box.hi.z)};
  }

 private:
  std::uint64_t state_;
};

/// The box scaled about its centre.
inline Box scaled(const Box& box, double factor) noexcept {
  const auto side = [factor](double lo, double hi, double& a, double& b) {
    const double middle = lo / 2 + hi / 2, half = (hi / 2 - lo / 2) * factor;
    a = middle - half;
    b = middle + half;
  };
  Box result;
  side(box.lo.x, box.hi.x, result.lo.x, result.hi.x);
  side(box.lo.y, box.hi.y, result.lo.y, result.hi.y);
  side(box.lo.z, box.hi.z, result.lo.z, result.hi.z);
  return result;
}

inline double longest(const Box& box) noexcept {
  return std::max({box.hi.x - box.lo.x, box.hi.y - box.lo.y, box.hi.z - box.lo.z});
}

}  // namespace cdfr::test
