/// Binary STL in two steps, so that a caller says where the mesh lies and how much is read at a time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "cdfr/core/result.h"
#include "cdfr/core/types.h"

namespace cdfr {

/// How many triangles the file has, each with three vertices of its own. Errors: file_truncated, file_format,
/// out_of_range.
Result<std::uint64_t> count_stl_binary(std::span<const std::byte> bytes);

/// As many triangles as there is room for, from number `first` on, and their vertices. Precondition: the file
/// has so many, and `vertices` is three times as long as `triangles`. Error: not_finite.
Result<void> read_stl_triangles(std::span<const std::byte> bytes, std::uint64_t first,
                                std::span<Triangle> triangles, std::span<Vec3> vertices);

}  // namespace cdfr
