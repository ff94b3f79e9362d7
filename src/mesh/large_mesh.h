/// A mesh that may be larger than what the work is allowed to hold.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "cdfr/core/result.h"
#include "cdfr/mesh/mesh.h"
#include "core/array.h"
#include "core/progress.h"
#include "core/scratch.h"

namespace cdfr {

/// A Mesh that does not change, wherever it lies.
struct LargeMesh {
  Array<Vec3> vertices;
  Array<Triangle> triangles;
  Array<std::uint32_t> patches;          ///< one id a triangle, or empty
  std::vector<std::string> patch_names;  ///< by patch id

  MeshView view() const noexcept {
    return {std::span<const Vec3>(vertices), std::span<const Triangle>(triangles),
            std::span<const std::uint32_t>(patches)};
  }
};

/// What read_mesh reads, bit by bit, in the scratch, which must outlive it; `flipped`: as flip() leaves it.
/// A binary STL goes there a piece at a time and is never held as a whole. Other formats are read by
/// read_mesh first, so for a while they take about as much of the heap as the Mesh does, and they cannot be
/// cancelled before they are read. Errors: read_mesh's, cancelled.
Result<LargeMesh> read_large_mesh(const std::filesystem::path& path, const Scratch& scratch, bool flipped,
                                  Progress& progress);

}  // namespace cdfr
