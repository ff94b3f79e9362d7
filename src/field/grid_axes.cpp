#include "field/grid_axes.h"

#include "geometry/query_range.h"

namespace cdfr {
namespace {

double& coordinate(Vec3& p, int axis) noexcept { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; }

}  // namespace

GridAxes::GridAxes(const Grid& grid, const LeafIndex& index) {
  for (int axis = 0; axis < 3; ++axis) {
    axes_[axis].resize(grid.size[axis]);
    for (std::uint32_t i = 0; i < grid.size[axis]; ++i) {
      Vec3 sample = grid.point(i, i, i);
      Coordinate& c = axes_[axis][i];
      // A point of the brick but for this coordinate.
      Vec3 p = index.domain().lo;
      coordinate(p, axis) = coordinate(sample, axis);
      c = {coordinate(sample, axis), 0, 0, false};
      if (!is_finite(p)) continue;
      p = without_dust(p);
      c.x = coordinate(p, axis);
      c.in_brick = index.contains(p);
      if (!c.in_brick) continue;
      LatticePoint point = index.place(p);
      c.at = coordinate(point.at, axis);
      c.place = point.place[axis];
    }
  }
}

}  // namespace cdfr
