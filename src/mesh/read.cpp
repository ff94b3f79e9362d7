#include "cdfr/mesh/read.h"

#include <algorithm>
#include <string>

#include "core/mapped_file.h"
#include "mesh/readers.h"
#include "mesh/text.h"

namespace cdfr {
namespace {

/// An ASCII STL has no zero byte where a binary one with "solid" in its header has the high byte of its
/// count.
bool has_zero_byte(std::span<const std::byte> bytes) noexcept {
  return std::find(bytes.begin(), bytes.end(), std::byte{0}) != bytes.end();
}

std::string_view first_word(std::span<const std::byte> bytes) noexcept {
  return TextReader(bytes).word_on_any_line();
}

bool is_ply(std::span<const std::byte> bytes) noexcept {
  return begins_with(bytes, "ply\n") || begins_with(bytes, "ply\r");
}

Result<Mesh> unknown_format(std::span<const std::byte> bytes) {
  if (begins_with(bytes, "\x1f\x8b"))
    return Error{Code::file_format, 0, "is compressed (gzip); unpack it first"};
  return Error{Code::file_format, 0, "is no STL, OBJ, PLY, glTF or GLB"};
}

}  // namespace

MeshReader reader_of(std::span<const std::byte> bytes, std::string_view extension) {
  if (begins_with(bytes, "glTF")) return read_gltf;
  if (is_ply(bytes)) return read_ply;
  if (is_binary_stl(bytes)) return read_stl_binary;
  const std::string_view word = first_word(bytes.first(std::min<std::size_t>(bytes.size(), 512)));
  if (equal_ignoring_case(word, "solid")) {
    const bool binary = bytes.size() >= 84 && has_zero_byte(bytes.first(84));
    return binary ? read_stl_binary : read_stl_ascii;
  }
  if (word.starts_with('{')) return read_gltf;
  if (begins_with(bytes, "\x1f\x8b")) return unknown_format;
  if (equal_ignoring_case(extension, ".stl")) return read_stl_binary;
  if (equal_ignoring_case(extension, ".obj")) return read_obj;
  if (equal_ignoring_case(extension, ".ply")) return read_ply;
  if (equal_ignoring_case(extension, ".gltf") || equal_ignoring_case(extension, ".glb")) return read_gltf;
  return unknown_format;
}

Result<Mesh> read_mesh_bytes(std::span<const std::byte> bytes, std::string_view extension) {
  return reader_of(bytes, extension)(bytes);
}

Result<Mesh> read_mesh(const std::filesystem::path& path) {
  const auto file = MappedFile::open(path);
  if (!file) return file.error();
  return read_mesh_bytes(file->bytes(), path.extension().string());
}

}  // namespace cdfr
