/// Measures walls at many points, by either method, on all threads.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "analysis/measured_wall.h"
#include "cdfr/analysis/thickness.h"
#include "cdfr/core/result.h"
#include "core/progress.h"
#include "field/field_data.h"

namespace cdfr {

/// Nothing, or what is wrong with the options or the field for them.
Result<void> check_thickness(const FieldData& field, const ThicknessOptions& options);

/// Options with nothing left to choose. Precondition: check_thickness was content.
class WallSurvey {
 public:
  WallSurvey(const FieldData& field, const ThicknessOptions& options) noexcept;

  double error() const noexcept { return error_; }
  double largest() const noexcept { return largest_; }
  double rounding() const noexcept { return rounding_; }
  /// The error can be told from rounding.
  Result<void> check() const;

  /// walls[i] belongs to points[i], whatever the order in which they are taken. Steps `progress` once for
  /// each of steps(). Returns closest points or rays asked. Runs in the caller's task arena.
  std::uint64_t measure(std::span<const WallPoint> points, std::span<MeasuredWall> walls,
                        Progress& progress) const;
  static double steps(std::size_t points) noexcept;

 private:
  std::uint64_t measure_some(std::span<const WallPoint> points, std::span<MeasuredWall> walls,
                             Progress& progress) const;

  const FieldData& field_;
  ThicknessOptions options_;
  double error_, largest_, rounding_;
};

}  // namespace cdfr
