/// Do two triangles of a mesh meet beyond what they share? Exact.
///
/// Triangles are closed. What counts, by the number of vertices that both have:
///  0  any common point, so touching counts;
///  1  any common point but that vertex;
///  2  any common point off the common edge: they lie in one plane with their apexes on one side of it;
///  3  nothing: that is a duplicate, which is another defect.
/// A triangle of no area is in contact with nothing.
#pragma once

#include <array>
#include <cstdint>

#include "cdfr/core/types.h"

namespace cdfr {

/// Two corners with one vertex number are at one place. Corners at one place with different numbers are
/// different vertices that touch.
struct ContactTriangle {
  std::array<Vec3, 3> corners;
  std::array<std::uint32_t, 3> vertices;
  Vec3 normal = {};  ///< unit_normal rounded to double, or zero if it is not known
};

/// One triangle that is asked about many others.
class ContactProbe {
 public:
  ContactProbe() = default;
  /// Preconditions here and below: coordinates as in query_range.h.
  explicit ContactProbe(const ContactTriangle& triangle) noexcept;

  bool has_area() const noexcept { return has_area_; }
  bool meets(const ContactTriangle& other) const noexcept;

 private:
  ContactTriangle triangle_;
  int axis_ = 0;  ///< leaving it out leaves the triangle an area, if it has any
  bool has_area_ = false;
};

/// Do the closed segment and the closed triangle meet? Preconditions: the segment has a length, the triangle
/// an area.
bool segment_meets_triangle(const std::array<Vec3, 2>& segment, const std::array<Vec3, 3>& triangle) noexcept;

}  // namespace cdfr
