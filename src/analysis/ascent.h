/// The way up: from a point inside to the critical cell that the ball about it grows towards.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "analysis/critical_cells.h"
#include "core/progress.h"
#include "field/field_data.h"
#include "field/near_triangles.h"

namespace cdfr {

/// Follows the direction in which all triangles that can be closest recede (common_direction.h). The distance
/// to a convex set never grows more slowly farther along a line, so a step along it, within which no other
/// triangle can become closest, makes the depth larger; longer ones are tried and kept while it grows. Steps
/// are shorter than the depth, so the way never leaves the part.
class Ascent {
 public:
  Ascent(const FieldData& field, const CriticalCells& critical) noexcept
      : field_(field), critical_(critical) {}

  /// The critical cell reached from x, or CriticalCells::none where the way ends elsewhere: at a point with
  /// no direction up, or after very many steps. `depth` is that of x, above the cell's diagonal.
  std::size_t climb(const Eigen::Vector3d& x, double depth, Progress& progress);

 private:
  Eigen::Vector3d way_up(const Eigen::Vector3d& x, double depth, double step);
  bool step_up(Eigen::Vector3d& x, double& depth);
  std::size_t cell_at(const Eigen::Vector3d& x) const noexcept;
  double depth_at(const Eigen::Vector3d& x) const noexcept;

  const FieldData& field_;
  const CriticalCells& critical_;
  std::vector<NearTriangle> near_;
  std::vector<Eigen::Vector3d> away_;
};

}  // namespace cdfr
