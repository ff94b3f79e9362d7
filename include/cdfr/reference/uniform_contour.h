/// Contours of a uniform field by the sub-voxel rules of the source papers.
#pragma once

#include <cstdint>
#include <vector>

#include "cdfr/core/api.h"
#include "cdfr/core/result.h"
#include "cdfr/core/run.h"
#include "cdfr/core/sinks.h"
#include "cdfr/reference/uniform.h"

namespace cdfr {

/// Where a contour is looked for.
enum class UniformRegions : std::uint8_t {
  voxels,       ///< papers/huang-2001, equation 2: voxels whose centre's distance is within sqrt(3)/2 s of t
  inter_voxel,  ///< papers/huang-2001-report, 3.4: between 8 voxel centres that reach both t or less and t or
                ///< more
};

/// Which sub-voxels are kept, for edge h, distance d at the centre and tolerance E.
enum class UniformKeep : std::uint8_t {
  half_tolerance,  ///< the papers': sqrt(3)/2 h < E and |d - t| <= E/2. Has holes
  half_diagonal,   ///< cdfr's, DESIGN.md promise 5: sqrt(3)/2 h <= E/2 and |d - t| <= sqrt(3)/2 h
};

/// What the distance at a sub-voxel is.
enum class UniformValue : std::uint8_t {
  base_triangle,   ///< papers/huang-2001, 3.2: of the closest triangle, by the base triangle's side
  least_positive,  ///< the same, 3.5 by the letter: the least positive one among all listed triangles
};

struct UniformContourOptions {
  /// E; 0 takes the longest side / 500, as the paper does. Sub-voxels: at most 64 along a voxel's edge.
  double tolerance = 0;
  UniformRegions regions = UniformRegions::voxels;
  UniformKeep keep = UniformKeep::half_tolerance;
  UniformValue value = UniformValue::base_triangle;
};

struct UniformContourReport {
  std::uint64_t regions = 0;      ///< voxels, or spaces between eight of them
  std::uint64_t visited = 0;      ///< those that passed the test
  std::uint64_t productive = 0;   ///< those that gave a point
  std::uint64_t evaluations = 0;  ///< sub-voxels tried
  std::uint64_t points = 0;
  double subvoxel = 0;  ///< edge of a sub-voxel
};

/// Centres of the sub-voxels that are kept, at depth `depth` > 0 below the surface: the paper's t. A point's
/// normal is the paper's: the base triangle's outward one, or, closest to an edge or vertex, from there to
/// the point, which is inward (inter_voxel: always the closest triangle's). Its error is |d - t| where moving
/// towards the surface ends on the contour, infinite where d < t: then nothing says that the contour is near.
/// Points come by region, x first, the same for any number of threads. Errors: bad_option (depth not finite
/// or not positive; tolerance not positive, or too fine for the voxels), cancelled, and the sink's own.
CDFR_API Result<UniformContourReport> contour_points(const UniformField& field, double depth,
                                                     const UniformContourOptions& options, PointSink& sink,
                                                     const Run& run = {});

/// The same, collected.
CDFR_API Result<std::vector<ContourPoint>> contour_points(const UniformField& field, double depth,
                                                          const UniformContourOptions& options = {},
                                                          const Run& run = {});

}  // namespace cdfr
