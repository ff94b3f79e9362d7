/// The way up: from a point inside to where the ball about it cannot grow by moving.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/progress.h"
#include "field/field_data.h"
#include "field/near_triangles.h"
#include "geometry/cube.h"

namespace cdfr {

struct CriticalCells;

/// Follows the direction in which all triangles that can be closest recede (common_direction.h). The distance
/// to a convex set never grows more slowly farther along a line, so a step along it, within which no other
/// triangle can become closest, makes the depth larger; longer ones are tried and kept while it grows. Steps
/// are shorter than the depth, so the way never leaves the part.
class Ascent {
 public:
  explicit Ascent(const FieldData& field) noexcept : field_(field) {}

  /// The critical cell reached from x, or CriticalCells::none where the way ends elsewhere: at a point with
  /// no direction up, or after very many steps. `depth` is that of x, above the error of the cells.
  std::size_t climb(const CriticalCells& critical, const Vec3& x, double depth, Progress& progress);
  /// The highest point of the cube that the way up from its centre comes to, in steps from half its edge down
  /// to that length. Preconditions: all of the cube is inside; `depth` is that of its centre; `among` are the
  /// slots of all triangles that can be closest in it.
  Vec3 top_in(const Cube& cube, double depth, double shortest, std::span<const std::uint32_t> among);

 private:
  Eigen::Vector3d way_up(const Eigen::Vector3d& x, double depth, double step);
  Eigen::Vector3d away_from_near();
  bool step_up(const CriticalCells& critical, Eigen::Vector3d& x, double& depth);
  double depth_at(const Eigen::Vector3d& x) const noexcept;
  std::size_t cell_at(const CriticalCells& critical, const Eigen::Vector3d& x) const noexcept;

  const FieldData& field_;
  std::vector<NearTriangle> near_;
  std::vector<Eigen::Vector3d> away_;
};

}  // namespace cdfr
