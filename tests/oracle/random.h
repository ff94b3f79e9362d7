/// Random numbers with the same bits on every machine; the standard's distributions do not promise that.
#pragma once

#include <cmath>
#include <cstdint>

#include "cdfr/core/types.h"

namespace cdfr::oracle {

class Random {
 public:
  explicit Random(std::uint64_t seed) noexcept : state_(seed) {}

  /// Weyl sequence, mixed by xor-shifts and odd factors.
  std::uint64_t bits() noexcept {
    state_ += 0x9E3779B97F4A7C15U;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9U;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBU;
    return z ^ (z >> 31);
  }
  std::uint64_t below(std::uint64_t end) noexcept { return bits() % end; }
  /// In [0, 1).
  double unit() noexcept { return static_cast<double>(bits() >> 11) * 0x1p-53; }
  double between(double low, double high) noexcept { return low + (high - low) * unit(); }
  /// Evenly spread in its binary exponent.
  double magnitude(int low_exponent, int high_exponent) noexcept {
    const auto span = static_cast<std::uint64_t>(high_exponent - low_exponent);
    return std::ldexp(1 + unit(), low_exponent + static_cast<int>(below(span)));
  }
  /// About 10^low to 10^high, evenly spread in the exponent. The fraction of the binary exponent becomes a
  /// mantissa, which needs no function of libm.
  double power_of_ten(double low, double high) noexcept {
    const double exponent = between(low, high) * 3.321928094887362;
    const double whole = std::floor(exponent);
    return std::ldexp(1 + (exponent - whole), static_cast<int>(whole));
  }
  double signed_unit() noexcept { return 2 * unit() - 1; }
  /// Of length 1, evenly spread.
  Vec3 direction() noexcept {
    for (;;) {
      const Vec3 d{signed_unit(), signed_unit(), signed_unit()};
      const double square = d.x * d.x + d.y * d.y + d.z * d.z;
      if (square > 1e-4 && square <= 1) {
        const double size = std::sqrt(square);
        return {d.x / size, d.y / size, d.z / size};
      }
    }
  }

 private:
  std::uint64_t state_;
};

}  // namespace cdfr::oracle
