/// Which coordinates the engine takes: 0, or 2^-200 to 2^200 in size, so that no product in the kernels
/// overflows or loses bits to underflow.
#pragma once

#include <cmath>
#include <optional>

#include "cdfr/core/result.h"
#include "cdfr/core/types.h"

namespace cdfr {

inline std::optional<Code> coordinate_fault(double x) noexcept {
  const double size = std::fabs(x);
  if ((size >= 0x1p-200 && size <= 0x1p200) || size == 0) return std::nullopt;
  return std::isfinite(x) ? Code::out_of_range : Code::not_finite;
}

inline std::optional<Code> coordinate_fault(const Vec3& p) noexcept {
  std::optional<Code> fault = coordinate_fault(p.x);
  if (!fault) fault = coordinate_fault(p.y);
  if (!fault) fault = coordinate_fault(p.z);
  return fault;
}

/// How a fault of a coordinate is named in messages.
inline const char* coordinate_fault_text(Code fault) noexcept {
  if (fault == Code::not_finite) return "has a coordinate that is not finite";
  if (fault == Code::out_of_range) return "has a coordinate outside 2^-200 to 2^200";
  return "has a coordinate that is no number";
}

}  // namespace cdfr
