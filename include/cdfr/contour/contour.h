/// Contours of the signed distance as points, at any tolerance, from one field.
#pragma once

#include <cstdint>
#include <vector>

#include "cdfr/core/api.h"
#include "cdfr/core/result.h"
#include "cdfr/core/run.h"
#include "cdfr/core/sinks.h"
#include "cdfr/field/field.h"

namespace cdfr {

/// Which sub-voxels give a point, for edge s, centre c and tolerance E.
enum class Rule : std::uint8_t {
  closed,  ///< sqrt(3)/2 s <= E/2 and |d(c) - t| <= sqrt(3)/2 s; the point is moved on the contour: no hole,
           ///< no ghost
  paper,   ///< the source paper's (Huang et al. 2001, section 3.6): sqrt(3)/2 s < E and |d(c) - t| <= E/2; the
           ///< point is the centre. It loses sheets that lie along the axes. For comparison
};

struct ContourOptions {
  /// E: with Rule::closed the largest distance from any point of the true contour to an extracted one; 0
  /// takes the longest side / 1000.
  double tolerance = 0;
  Rule rule = Rule::closed;
};

struct ContourReport {
  std::uint64_t leaves = 0;       ///< of the field
  std::uint64_t visited = 0;      ///< those whose centre's distance allows a point in them
  std::uint64_t productive = 0;   ///< those that gave a point
  std::uint64_t evaluations = 0;  ///< of the distance, but for those of exclusion tests
  std::uint64_t points = 0;
  std::uint64_t undecided = 0;  ///< points with an infinite error: 2^-10 of a sub-voxel did not decide
  double subvoxel = 0;          ///< edge of the smallest sub-voxel used at leaf level, in the mesh's unit
  double max_error = 0;         ///< largest finite ContourPoint::error
  Box box;                      ///< of the points; lo > hi if there are none
};

/// Points of the contour {x : signed distance = distance}; a depth t is distance -t. No hole: within the
/// tolerance of every point of the true contour there is a point. No ghost: the true contour passes within
/// each point's error. With Rule::paper neither holds; a point's error is |d - t| where moving towards the
/// surface ends on the contour, else infinite. On an open mesh the contour ends where the sign changes off the surface. Points come in Morton order, the same for any thread count. An empty contour is an
/// answer, not an error. Errors: bad_option (distance or tolerance not finite; tolerance below 2^-40 of the
/// longest side or 64 ulp of the largest coordinate), not_closed (a negative distance of an unsigned field),
/// cancelled, and the sink's own.
CDFR_API Result<ContourReport> contour_points(const Field& field, double distance,
                                              const ContourOptions& options, PointSink& sink,
                                              const Run& run = {});

/// The same, collected.
CDFR_API Result<std::vector<ContourPoint>> contour_points(const Field& field, double distance,
                                                          const ContourOptions& options = {},
                                                          const Run& run = {});

}  // namespace cdfr
