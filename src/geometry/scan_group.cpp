#include "geometry/scan_group.h"

#include <algorithm>
#include <cmath>

namespace cdfr {
namespace {

constexpr double most_units = 32767;
/// Keeps squares of whole distances finite: 16 edges are 2^60 units at most.
constexpr double least_unit = 0x1p-56;

}  // namespace

ScanGroup scan_group(const TriangleGroup& group, const Vec3& origin, double edge) noexcept {
  ScanGroup scan{};
  const double from[3] = {origin.x, origin.y, origin.z};
  const double scale = 1 / edge;  // exact: a power of two
  double farthest = 0;
  for (int axis = 0; axis < 3; ++axis) {
    double lo = HUGE_VAL, hi = -HUGE_VAL;
    for (const auto& corner : group.vertices) {
      const auto [least, most] = std::minmax_element(corner[axis], corner[axis] + group_size);
      lo = std::min(lo, (*least - from[axis]) * scale);
      hi = std::max(hi, (*most - from[axis]) * scale);
    }
    scan.origin[axis] = static_cast<float>((lo + hi) / 2);
    farthest = std::max({farthest, hi - scan.origin[axis], scan.origin[axis] - lo});
    for (std::size_t lane = 0; lane < group_size; ++lane) {
      scan.normals[axis][lane] = static_cast<float>(group.normals[axis][lane]);
    }
  }
  scan.unit = std::nextafter(static_cast<float>(std::max(farthest / most_units, least_unit)), HUGE_VALF);
  for (int corner = 0; corner < 3; ++corner) {
    for (int axis = 0; axis < 3; ++axis) {
      for (std::size_t lane = 0; lane < group_size; ++lane) {
        const double v = (group.vertices[corner][axis][lane] - from[axis]) * scale - scan.origin[axis];
        scan.vertices[corner][axis][lane] = static_cast<std::int16_t>(std::lround(v / scan.unit));
      }
    }
  }
  return scan;
}

}  // namespace cdfr
