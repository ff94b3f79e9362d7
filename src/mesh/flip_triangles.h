/// Triangles turned over, wherever they lie.
#pragma once

#include <span>
#include <utility>

#include "cdfr/core/types.h"

namespace cdfr {

/// What flip() does (cdfr/mesh/flip.h).
inline void flip_triangles(std::span<Triangle> triangles) noexcept {
  for (Triangle& triangle : triangles) std::swap(triangle[1], triangle[2]);
}

}  // namespace cdfr
