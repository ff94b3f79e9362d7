/// Where points go as they are found, so that a result of any length needs no more memory than a block of it.
#pragma once

#include <cstdint>
#include <span>

#include "cdfr/core/result.h"
#include "cdfr/core/types.h"

namespace cdfr {

/// One point of a contour. The true contour passes within `error` of `position`.
struct ContourPoint {
  Vec3 position;
  Vec3 normal;                        ///< gradient of the signed distance there, unit length
  std::uint32_t triangle = no_index;  ///< base triangle: its number in the input file
  double error = 0;                   ///< in the mesh's unit; infinite where nothing says that the contour is near
};

/// Receives blocks of points, in a fixed order, one call at a time.
class PointSink {
 public:
  virtual ~PointSink() = default;
  /// An error ends the extraction and is handed to its caller.
  virtual Result<void> write(std::span<const ContourPoint> points) = 0;
};

}  // namespace cdfr
