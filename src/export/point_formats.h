/// The formats of create_point_file.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <span>

#include "cdfr/core/result.h"
#include "cdfr/core/sinks.h"
#include "core/whole_file.h"

namespace cdfr {

/// How one format lays out points that come in blocks. The caller creates, counts, checks and finishes the
/// file.
class PointFormat {
 public:
  virtual ~PointFormat() = default;
  /// The most points that a file of this format holds.
  virtual std::uint64_t limit() const noexcept { return std::numeric_limits<std::uint64_t>::max(); }
  /// Appends what comes before the points.
  virtual Result<void> begin(WholeFile& file) = 0;
  /// Precondition: positions, normals and errors are finite; no more points than the limit.
  virtual Result<void> append(WholeFile& file, std::span<const ContourPoint> points) = 0;
  /// Patches what was not known at the start. `count` is the number of all points.
  virtual Result<void> end(WholeFile& file, std::uint64_t count) = 0;
};

/// Binary little endian: x y z nx ny nz error double, triangle uint.
std::unique_ptr<PointFormat> ply_points();
/// x,y,z,nx,ny,nz,triangle,error with a header line and 17 digits.
std::unique_ptr<PointFormat> csv_points();
/// GLB of one POINTS primitive, at most 4 GiB. Precondition: metres_per_unit is finite and positive.
std::unique_ptr<PointFormat> glb_points(double metres_per_unit);

}  // namespace cdfr
