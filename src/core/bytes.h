/// A bounded reader over foreign bytes: numbers of either byte order, never past the end.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <type_traits>

namespace cdfr {

template <std::size_t size>
using UnsignedOfSize =
    std::conditional_t<size == 1, std::uint8_t,
                       std::conditional_t<size == 2, std::uint16_t,
                                          std::conditional_t<size == 4, std::uint32_t, std::uint64_t>>>;

/// The number whose bytes start at `data` in the given order; `data` needs no alignment.
/// Precondition: sizeof(T) bytes are readable.
template <class T>
T load(const std::byte* data, std::endian order) noexcept {
  static_assert(std::is_arithmetic_v<T> && sizeof(T) <= 8);
  using Bits = UnsignedOfSize<sizeof(T)>;
  Bits bits = 0;
  std::memcpy(&bits, data, sizeof bits);
  if (order != std::endian::native) {
    Bits swapped = 0;
    for (std::size_t i = 0; i < sizeof bits; ++i) {
      swapped = static_cast<Bits>(swapped | ((bits >> 8 * i) & 0xff) << 8 * (sizeof bits - 1 - i));
    }
    bits = swapped;
  }
  return std::bit_cast<T>(bits);
}

template <class T>
T load_little(const std::byte* data) noexcept {
  return load<T>(data, std::endian::little);
}

template <class T>
T load_big(const std::byte* data) noexcept {
  return load<T>(data, std::endian::big);
}

/// Borrows the bytes. A call that would pass the end returns nothing and moves nothing.
class ByteReader {
 public:
  explicit ByteReader(std::span<const std::byte> bytes) noexcept : bytes_(bytes) {}

  std::size_t offset() const noexcept { return offset_; }
  std::size_t remaining() const noexcept { return bytes_.size() - offset_; }

  std::optional<std::span<const std::byte>> take(std::uint64_t count) noexcept {
    if (count > remaining()) return std::nullopt;
    const auto taken = bytes_.subspan(offset_, static_cast<std::size_t>(count));
    offset_ += taken.size();
    return taken;
  }

  template <class T>
  std::optional<T> number(std::endian order) noexcept {
    const auto taken = take(sizeof(T));
    if (!taken) return std::nullopt;
    return load<T>(taken->data(), order);
  }
  template <class T>
  std::optional<T> little() noexcept {
    return number<T>(std::endian::little);
  }
  template <class T>
  std::optional<T> big() noexcept {
    return number<T>(std::endian::big);
  }

 private:
  std::span<const std::byte> bytes_;
  std::size_t offset_ = 0;
};

}  // namespace cdfr
