/// The formats, each a function of bytes alone: nothing is opened, mapped or known of a file name here.
/// Errors and numbering as cdfr/mesh/read.h says.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "cdfr/core/result.h"
#include "cdfr/mesh/mesh.h"

namespace cdfr {

using MeshReader = Result<Mesh> (*)(std::span<const std::byte> bytes);

/// Tells the format by content; `extension` (".obj", any case, or empty) helps where the content cannot tell.
/// Of bytes that are no mesh the reader says so.
MeshReader reader_of(std::span<const std::byte> bytes, std::string_view extension);
Result<Mesh> read_mesh_bytes(std::span<const std::byte> bytes, std::string_view extension);
Result<std::vector<Vec3>> read_points_bytes(std::span<const std::byte> bytes);

/// The 80-byte header and count fit the size of the file exactly, so it is a binary STL whatever its first
/// word says.
bool is_binary_stl(std::span<const std::byte> bytes) noexcept;
Result<Mesh> read_stl_binary(std::span<const std::byte> bytes);
Result<Mesh> read_stl_ascii(std::span<const std::byte> bytes);
Result<Mesh> read_obj(std::span<const std::byte> bytes);
Result<Mesh> read_ply(std::span<const std::byte> bytes);
/// .gltf (JSON) and .glb (binary).
Result<Mesh> read_gltf(std::span<const std::byte> bytes);
Result<std::vector<Vec3>> read_npy(std::span<const std::byte> bytes);
Result<std::vector<Vec3>> read_csv(std::span<const std::byte> bytes);

}  // namespace cdfr
