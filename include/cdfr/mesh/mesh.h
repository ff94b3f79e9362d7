/// A triangle mesh: borrowed as a view, or owned.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "cdfr/core/points.h"
#include "cdfr/core/types.h"

namespace cdfr {

/// Borrowed arrays. A triangle's number is its place here, which for a mesh that was read is its place in the
/// file.
struct MeshView {
  Points vertices;
  std::span<const Triangle> triangles;
  std::span<const std::uint32_t> patches{};  ///< one id a triangle, or empty: all triangles are patch 0
};

struct Mesh {
  std::vector<Vec3> vertices;
  std::vector<Triangle> triangles;
  std::vector<std::uint32_t> patches;    ///< one id a triangle, or empty
  std::vector<std::string> patch_names;  ///< by patch id; as in the file, unescaped

  MeshView view() const noexcept { return {std::span<const Vec3>(vertices), triangles, patches}; }
};

}  // namespace cdfr
