/// The byte that tells a voxel's kind and its number of triangles: papers/huang-2001, section 5.3 and
/// figure 11.
#pragma once

#include <cstddef>
#include <cstdint>

#include "cdfr/octree/leaf.h"

namespace cdfr {

struct CountByte {
  Side side = Side::outside;
  std::size_t count = 0;
};

/// As the paper has it: 0 outside, n surface, 127 + n inside; of larger numbers a byte keeps the low bits.
inline std::uint8_t encode_count_byte(const CountByte& voxel) noexcept {
  if (voxel.side == Side::outside) return 0;
  return static_cast<std::uint8_t>(voxel.side == Side::inside ? 127 + voxel.count : voxel.count);
}

inline CountByte decode_count_byte(std::uint8_t byte) noexcept {
  if (byte == 0) return {};
  if (byte <= 127) return {Side::surface, byte};
  return {Side::inside, std::size_t{byte} - 127};
}

}  // namespace cdfr
