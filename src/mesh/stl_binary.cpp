// Binary STL: 80 bytes of anything, a count, and 50 bytes a triangle (normal, three corners, attribute),
// little endian.
#include "mesh/stl_binary.h"

#include <cassert>
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

Result<std::uint64_t> count_stl_binary(std::span<const std::byte> bytes) {
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
  return count;
}

Result<void> read_stl_triangles(std::span<const std::byte> bytes, std::uint64_t first,
                                std::span<Triangle> triangles, std::span<Vec3> vertices) {
  assert(size_for(first + triangles.size()) <= bytes.size() && vertices.size() == 3 * triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const std::uint64_t t = first + i;
    if (!read_corners(bytes.data() + size_for(t), &vertices[3 * i])) {
      return Error{Code::not_finite, t,
                   "triangle " + std::to_string(t) + " " + coordinate_fault_text(Code::not_finite)};
    }
    const auto corner = static_cast<std::uint32_t>(3 * t);
    triangles[i] = {corner, corner + 1, corner + 2};
  }
  return {};
}

Result<Mesh> read_stl_binary(std::span<const std::byte> bytes) {
  const Result<std::uint64_t> count = count_stl_binary(bytes);
  if (!count) return count.error();
  Mesh mesh;
  mesh.vertices.resize(3 * *count);
  mesh.triangles.resize(*count);
  if (auto read = read_stl_triangles(bytes, 0, mesh.triangles, mesh.vertices); !read) return read.error();
  return mesh;
}

}  // namespace cdfr
