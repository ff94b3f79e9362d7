/// Small files of every format, made of bytes here, and a way to read them that shows a sanitizer every
/// overrun.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "cdfr/mesh/mesh.h"
#include "mesh/readers.h"

namespace cdfr::samples {

/// A heap copy of exactly this size: one byte too far is an error under AddressSanitizer.
class ExactBytes {
 public:
  explicit ExactBytes(std::string_view text) : data_(new std::byte[text.size()]), size_(text.size()) {
    std::copy_n(reinterpret_cast<const std::byte*>(text.data()), size_, data_.get());
  }
  std::span<const std::byte> span() const { return {data_.get(), size_}; }

 private:
  std::unique_ptr<std::byte[]> data_;
  std::size_t size_;
};

inline Result<Mesh> read(std::string_view text, std::string_view extension = "") {
  return read_mesh_bytes(ExactBytes(text).span(), extension);
}

/// The number's bytes in the given order.
template <class T>
std::string raw(T value, std::endian order = std::endian::little) {
  std::string bytes(sizeof value, '\0');
  std::memcpy(bytes.data(), &value, sizeof value);
  if (order != std::endian::native) std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

inline const std::vector<Vec3>& cube_vertices() {
  static const std::vector<Vec3> vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                             {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  return vertices;
}

/// Six outward quads; as fans from their first corners they are the twelve triangles.
inline const std::vector<std::array<std::uint32_t, 4>>& cube_quads() {
  static const std::vector<std::array<std::uint32_t, 4>> quads = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                                                  {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  return quads;
}

inline std::vector<Triangle> cube_triangles() {
  std::vector<Triangle> triangles;
  for (const auto& q : cube_quads()) {
    triangles.push_back({q[0], q[1], q[2]});
    triangles.push_back({q[0], q[2], q[3]});
  }
  return triangles;
}

inline std::string binary_stl(std::string header = "made by a test") {
  header.resize(80, ' ');
  std::string bytes = header + raw(static_cast<std::uint32_t>(cube_triangles().size()));
  for (const auto& triangle : cube_triangles()) {
    bytes += raw(0.0F) + raw(0.0F) + raw(0.0F);
    for (const auto corner : triangle) {
      const Vec3 p = cube_vertices()[corner];
      bytes += raw(static_cast<float>(p.x)) + raw(static_cast<float>(p.y)) + raw(static_cast<float>(p.z));
    }
    bytes += raw(std::uint16_t{0});
  }
  return bytes;
}

inline std::string numbers(const Vec3& p) {
  return std::to_string(static_cast<int>(p.x)) + " " + std::to_string(static_cast<int>(p.y)) + " " +
         std::to_string(static_cast<int>(p.z));
}

inline std::string ascii_stl() {
  std::string text = "solid cube of a test\n";
  for (const auto& triangle : cube_triangles()) {
    text += " facet normal nan 0 0\n  outer loop\n";
    for (const auto corner : triangle) text += "   vertex " + numbers(cube_vertices()[corner]) + "\n";
    text += "  endloop\n endfacet\n";
  }
  return text + "endsolid cube of a test\n";
}

inline std::string obj() {
  std::string text = "# cube\nmtllib none.mtl\n";
  for (const auto& p : cube_vertices()) text += "v " + numbers(p) + "\n";
  for (const auto& q : cube_quads()) {
    text += "f";
    for (const auto corner : q) text += " " + std::to_string(corner + 1) + "/1/1";
    text += "\n";
  }
  return text;
}

inline std::string ply_header(std::string_view format) {
  return "ply\nformat " + std::string(format) +
         " 1.0\ncomment cube\nelement vertex 8\nproperty float x\nproperty double y\nproperty float z\n"
         "property uchar red\nproperty list uchar short tags\nelement edge 2\nproperty int vertex1\n"
         "element face 6\nproperty char flag\nproperty list uchar int vertex_indices\nend_header\n";
}

inline std::string ascii_ply() {
  std::string text = ply_header("ascii");
  for (const auto& p : cube_vertices()) text += numbers(p) + " 255 2 -7 9\n";
  text += "1\n2\n";
  for (const auto& q : cube_quads()) {
    text += "-1 4";
    for (const auto corner : q) text += " " + std::to_string(corner);
    text += "\n";
  }
  return text;
}

inline std::string binary_ply(std::endian order) {
  std::string bytes = ply_header(order == std::endian::big ? "binary_big_endian" : "binary_little_endian");
  for (const auto& p : cube_vertices()) {
    bytes += raw(static_cast<float>(p.x), order) + raw(p.y, order) + raw(static_cast<float>(p.z), order);
    bytes += raw(std::uint8_t{255}) + raw(std::uint8_t{2}) + raw(std::int16_t{-7}, order) +
             raw(std::int16_t{9}, order);
  }
  bytes += raw(std::int32_t{1}, order) + raw(std::int32_t{2}, order);
  for (const auto& q : cube_quads()) {
    bytes += raw(std::int8_t{-1}) + raw(std::uint8_t{4});
    for (const auto corner : q) bytes += raw(static_cast<std::int32_t>(corner), order);
  }
  return bytes;
}

/// 8 float positions, then 36 indices of 16 bits: 168 bytes.
inline std::string gltf_buffer() {
  std::string bytes;
  for (const auto& p : cube_vertices()) {
    bytes += raw(static_cast<float>(p.x)) + raw(static_cast<float>(p.y)) + raw(static_cast<float>(p.z));
  }
  for (const auto& triangle : cube_triangles()) {
    for (const auto corner : triangle) bytes += raw(static_cast<std::uint16_t>(corner));
  }
  return bytes;
}

/// The JSON for that buffer. `nodes` and `more` (further members, with a leading comma) are put in as they
/// are.
inline std::string gltf_json(std::string_view nodes = R"([{"mesh":0}])", std::string_view uri = "",
                             std::string_view more = "") {
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":)" + std::string(nodes) +
         R"(,"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],)"
         R"("accessors":[{"bufferView":0,"componentType":5126,"count":8,"type":"VEC3"},)"
         R"({"bufferView":1,"componentType":5123,"count":36,"type":"SCALAR"}],)"
         R"("bufferViews":[{"buffer":0,"byteLength":96},{"buffer":0,"byteOffset":96,"byteLength":72}],)"
         R"("buffers":[{"byteLength":168)" +
         std::string(uri) + "}]" + std::string(more) + "}";
}

inline std::string glb(std::string json, std::string binary = gltf_buffer()) {
  json.resize((json.size() + 3) / 4 * 4, ' ');
  binary.resize((binary.size() + 3) / 4 * 4, '\0');
  const auto size = [](std::size_t n) { return raw(static_cast<std::uint32_t>(n)); };
  return "glTF" + size(2) + size(12 + 8 + json.size() + 8 + binary.size()) + size(json.size()) + "JSON" +
         json + size(binary.size()) + std::string("BIN\0", 4) + binary;
}

inline std::string base64(std::string_view bytes) {
  static const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      bits = bits << 8 | (i + k < bytes.size() ? static_cast<std::uint8_t>(bytes[i + k]) : 0U);
    }
    for (std::size_t k = 0; k < 4; ++k)
      text += i + k > bytes.size() ? '=' : digits[bits >> (18 - 6 * k) & 63];
  }
  return text;
}

inline std::string gltf() {
  const std::string uri = R"(,"uri":"data:application/octet-stream;base64,)" + base64(gltf_buffer()) + "\"";
  return gltf_json(R"([{"mesh":0}])", uri);
}

struct Sample {
  std::string name;
  std::string extension;
  std::string bytes;
};

/// The same cube in every format.
inline std::vector<Sample> all() {
  return {{"binary STL", ".stl", binary_stl()},
          {"ASCII STL", ".stl", ascii_stl()},
          {"OBJ", ".obj", obj()},
          {"ASCII PLY", ".ply", ascii_ply()},
          {"little endian PLY", ".ply", binary_ply(std::endian::little)},
          {"big endian PLY", ".ply", binary_ply(std::endian::big)},
          {"GLB", ".glb", glb(gltf_json())},
          {"glTF", ".gltf", gltf()}};
}

}  // namespace cdfr::samples
