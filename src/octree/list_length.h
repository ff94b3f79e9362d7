/// How long lists should be for a number of queries.
#pragma once

#include <cstdint>

namespace cdfr {

/// The max_triangles_per_leaf for which building and that many queries take least, by a model of their cost.
/// Depends on these two numbers alone. At least 320, which keeps a field within 400 bytes a triangle.
int list_length_for(std::uint64_t triangles, std::uint64_t queries) noexcept;

}  // namespace cdfr
