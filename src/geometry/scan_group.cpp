#include "geometry/scan_group.h"

#include <algorithm>
#include <cmath>

namespace cdfr {

ScanGroup scan_group(const TriangleGroup& group, const Vec3& origin, double edge) noexcept {
  ScanGroup scan{};
  const double from[3] = {origin.x, origin.y, origin.z};
  const double scale = 1 / edge;  // exact: a power of two
  double reach = 0;
  for (int axis = 0; axis < 3; ++axis) {
    double lo = HUGE_VAL, hi = -HUGE_VAL;
    for (const auto& corner : group.vertices) {
      for (std::size_t lane = 0; lane < group_size; ++lane) {
        const double v = (corner[axis][lane] - from[axis]) * scale;
        lo = std::min(lo, v);
        hi = std::max(hi, v);
      }
    }
    scan.origin[axis] = static_cast<float>((lo + hi) / 2);
    const double away = std::max(hi - scan.origin[axis], scan.origin[axis] - lo);
    reach += away * away;
    for (int corner = 0; corner < 3; ++corner) {
      for (std::size_t lane = 0; lane < group_size; ++lane) {
        const double v = (group.vertices[corner][axis][lane] - from[axis]) * scale;
        scan.vertices[corner][axis][lane] = static_cast<float>(v - scan.origin[axis]);
      }
    }
    for (std::size_t lane = 0; lane < group_size; ++lane) {
      scan.normals[axis][lane] = static_cast<float>(group.normals[axis][lane]);
    }
  }
  scan.reach = std::nextafter(static_cast<float>(2 * std::sqrt(reach)), HUGE_VALF);
  return scan;
}

}  // namespace cdfr
