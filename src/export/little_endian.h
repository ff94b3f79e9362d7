/// Numbers as little endian bytes, whatever the machine's own order is.
#pragma once

#include <array>
#include <bit>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <span>

namespace cdfr {

/// One record of a binary file, filled from the left. Precondition of every append: it fits.
template <std::size_t capacity>
class Record {
 public:
  void append(std::uint8_t value) noexcept { append_bytes(value, 1); }
  void append(std::uint16_t value) noexcept { append_bytes(value, 2); }
  void append(std::uint32_t value) noexcept { append_bytes(value, 4); }
  void append(std::uint64_t value) noexcept { append_bytes(value, 8); }
  void append(float value) noexcept { append_bytes(std::bit_cast<std::uint32_t>(value), 4); }
  void append(double value) noexcept { append_bytes(std::bit_cast<std::uint64_t>(value), 8); }

  std::span<const std::byte> bytes() const noexcept { return {bytes_.data(), size_}; }

 private:
  void append_bytes(std::uint64_t value, std::size_t count) noexcept {
    assert(size_ + count <= capacity);
    for (std::size_t i = 0; i < count; ++i) bytes_[size_++] = static_cast<std::byte>(value >> (8 * i));
  }

  std::array<std::byte, capacity> bytes_{};
  std::size_t size_ = 0;
};

}  // namespace cdfr
