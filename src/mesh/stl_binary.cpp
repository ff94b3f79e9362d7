// Binary STL: 80 bytes of anything, a count, and 50 bytes a triangle (normal, three corners, attribute),
// little endian.
#include <cmath>
#include <cstdint>
#include <string>

#include "core/bytes.h"
#include "mesh/coordinate.h"
#include "mesh/readers.h"

namespace cdfr {
namespace {

constexpr std::uint64_t header_size = 84;
constexpr std::uint64_t record_size = 50;
constexpr std::uint64_t normal_size = 12;
constexpr std::uint64_t most_triangles = (no_index - 1) / 3;  // three vertices each, numbered in 32 bits

std::uint64_t size_for(std::uint64_t count) noexcept { return header_size + record_size * count; }

std::uint64_t triangle_count(std::span<const std::byte> bytes) noexcept {
  return load_little<std::uint32_t>(bytes.data() + header_size - 4);
}

Error size_mismatch(std::uint64_t count, std::uint64_t size) {
  const std::string numbers = "binary STL header counts " + std::to_string(count) + " triangles, which are " +
                              std::to_string(size_for(count)) + " bytes, but the file has " +
                              std::to_string(size);
  return {size < size_for(count) ? Code::file_truncated : Code::file_format, header_size - 4, numbers};
}

/// Every float but NaN and infinity is within the supported coordinates.
bool read_corners(const std::byte* record, Vec3* corners) noexcept {
  bool finite = true;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::byte* at = record + normal_size + 12 * k;
    const float x = load_little<float>(at);
    const float y = load_little<float>(at + 4);
    const float z = load_little<float>(at + 8);
    finite = finite && std::isfinite(x) && std::isfinite(y) && std::isfinite(z);
    corners[k] = {x, y, z};
  }
  return finite;
}

}  // namespace

bool is_binary_stl(std::span<const std::byte> bytes) noexcept {
  return bytes.size() >= header_size && bytes.size() == size_for(triangle_count(bytes));
}

Result<Mesh> read_stl_binary(std::span<const std::byte> bytes) {
  if (bytes.size() < header_size) {
    return Error{Code::file_truncated, bytes.size(),
                 "binary STL needs " + std::to_string(header_size) +
                     " bytes of header and count, the file has " + std::to_string(bytes.size())};
  }
  const std::uint64_t count = triangle_count(bytes);
  if (bytes.size() != size_for(count)) return size_mismatch(count, bytes.size());
  if (count > most_triangles) {
    return Error{Code::out_of_range, header_size - 4,
                 "binary STL has " + std::to_string(count) + " triangles, more than " +
                     std::to_string(most_triangles)};
  }
  Mesh mesh;
  mesh.vertices.resize(3 * count);
  mesh.triangles.resize(count);
  for (std::uint64_t t = 0; t < count; ++t) {
    if (!read_corners(bytes.data() + size_for(t), &mesh.vertices[3 * t])) {
      return Error{Code::not_finite, t,
                   "triangle " + std::to_string(t) + " " + coordinate_fault_text(Code::not_finite)};
    }
    const auto first = static_cast<std::uint32_t>(3 * t);
    mesh.triangles[t] = {first, first + 1, first + 2};
  }
  return mesh;
}

}  // namespace cdfr
