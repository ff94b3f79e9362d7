#include "binary.h"

namespace cdfr::command {

std::string npy_header(const std::string& shape) {
  constexpr std::size_t before = 10, alignment = 64;
  std::string header = "{'descr': '<f8', 'fortran_order': False, 'shape': " + shape + ", }";
  header.append(alignment - 1 - (before + header.size()) % alignment, ' ');
  header += '\n';
  std::string bytes = "\x93NUMPY";
  bytes += std::string("\x01\x00", 2);
  append_bytes(bytes, static_cast<std::uint16_t>(header.size()));
  return bytes + header;
}

}  // namespace cdfr::command
