/// Numbers of the GLB and glTF 2.0 specification.
#pragma once

#include <array>
#include <cstdint>

namespace cdfr::glb {

using Float3 = std::array<float, 3>;

inline constexpr std::uint32_t magic = 0x46546c67, version_2 = 2;
inline constexpr std::uint32_t json_chunk = 0x4e4f534a, binary_chunk = 0x004e4942;
inline constexpr std::uint32_t chunk_header_bytes = 8;
inline constexpr std::uint32_t json_start = 12 + chunk_header_bytes;
inline constexpr int float_component = 5126, unsigned_component = 5125;
inline constexpr int vertex_target = 34962, index_target = 34963;
inline constexpr int points_mode = 0, lines_mode = 1, triangles_mode = 4;

}  // namespace cdfr::glb
