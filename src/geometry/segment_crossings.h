/// How often a segment passes through a surface, counted triangle by triangle: exact.
#pragma once

#include "cdfr/core/types.h"
#include "geometry/triangle_group.h"

namespace cdfr {

/// What passes through eight triangles. One bit a lane: out at the triangle's front, in there, or rounding
/// leaves it open.
struct Passages {
  unsigned out = 0, in = 0, open = 0;
};

/// Along the segment from p to q: passages from behind a triangle to its front count 1, others -1, so that of
/// a closed mesh they add up to w(p) - w(q), w the winding number.
class SegmentCrossings {
 public:
  SegmentCrossings(const Vec3& p, const Vec3& q) noexcept : p_(p), q_(q) {}

  /// Adds a group's triangles of the given lanes but for those of no area. False, and nothing of use in
  /// total(), where an end may lie on a triangle or the segment meets the border of one.
  bool add(const TriangleGroup& group, unsigned lanes) noexcept;
  int total() const noexcept { return total_; }

 private:
  bool add(const Vec3& a, const Vec3& b, const Vec3& c) noexcept;

  Vec3 p_, q_;
  int total_ = 0;
};

}  // namespace cdfr
