/// Linear functions on a cube, and bounds on the volume where what lies between them is above 0.
#pragma once

#include <array>

#include "cdfr/core/types.h"

namespace cdfr {

/// A volume that is at least one thing and at most another.
struct VolumeBounds {
  double sure = 0, possible = 0;
};

/// o + w.y as (o, w), y from the cube's centre.
using LinearFunction = std::array<double, 4>;

/// The least and the greatest of some linear functions, coefficient by coefficient. On a cube of half an edge
/// a all of them are within
///     spread = max |o_k - o| + a sum over axes of max |w_k - w|
/// of the one in the middle, (o, w).
class PlaneRange {
 public:
  void add(double offset, const Vec3& way) noexcept;

  bool is_empty() const noexcept { return !(least_[0] <= most_[0]); }
  double least_offset() const noexcept { return least_[0]; }
  LinearFunction middle() const noexcept;
  double spread(double half) const noexcept;

 private:
  static constexpr double none = __builtin_huge_val();
  LinearFunction least_{none, none, none, none}, most_{-none, -none, -none, -none};
};

/// Of the part of the cube [-half, half]^3 where a function that is within `spread` of this one is above 0.
VolumeBounds volume_above(const LinearFunction& function, double spread, double half) noexcept;

}  // namespace cdfr
