/// Are two answers the same, bit for bit?
#pragma once

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>

#include "cdfr/field/field.h"

namespace cdfr::test {

inline bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}
inline bool same_bits(const Vec3& a, const Vec3& b) {
  return same_bits(a.x, b.x) && same_bits(a.y, b.y) && same_bits(a.z, b.z);
}

inline bool same_bits(const Closest& a, const Closest& b) {
  bool same = same_bits(a.distance, b.distance) && same_bits(a.point, b.point) &&
              same_bits(a.gradient, b.gradient) && a.triangle == b.triangle && a.patch == b.patch &&
              a.feature == b.feature && a.element == b.element;
  for (int i = 0; i < 3; ++i) same = same && same_bits(a.barycentric[i], b.barycentric[i]);
  return same;
}

}  // namespace cdfr::test
