/// Numbers as bytes of a file, little endian on every machine.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>

namespace cdfr::command {

template <class Integer>
void append_bytes(std::string& bytes, Integer value) {
  for (std::size_t i = 0; i < sizeof value; ++i) bytes += static_cast<char>(value >> (8 * i) & 0xFFU);
}
inline void append_bytes(std::string& bytes, double value) {
  append_bytes(bytes, std::bit_cast<std::uint64_t>(value));
}

/// What an NPY file of doubles begins with. `shape` as Python writes it: "(3, 4)".
std::string npy_header(const std::string& shape);

}  // namespace cdfr::command
