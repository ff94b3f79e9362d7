/// A first picture of a point contour: orthographic, depth-shaded splats.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>

#include "cdfr/core/api.h"
#include "cdfr/core/result.h"
#include "cdfr/core/sinks.h"
#include "cdfr/mesh/mesh.h"

namespace cdfr {

struct SplatOptions {
  int width = 1200, height = 900;  ///< pixels, 16 to 16384
  Vec3 towards{-1, -1.4, -0.9};    ///< viewing direction, not zero
  Vec3 up{0, 0, 1};                ///< not along `towards`
};

/// Draws the points shaded by normal and depth, and the part around them as a faint silhouette (pass an empty mesh for
/// none), and writes a PNG. The same bytes on every machine. Errors: bad_option, file_write. O(points + triangles).
CDFR_API Result<void> splat_png(std::span<const ContourPoint> points, MeshView part, const std::filesystem::path& path,
                                const SplatOptions& options = {});

}  // namespace cdfr
