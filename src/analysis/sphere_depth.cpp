#include "analysis/sphere_depth.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/vector.h"
#include "field/query.h"
#include "geometry/cube.h"

namespace cdfr {
namespace {

class SphereSearch {
 public:
  SphereSearch(const FieldData& field, const Vec3& centre, double radius, double error, Progress& progress)
      : field_(field), centre_(to_eigen(centre)), radius_(radius), error_(error), progress_(progress) {}

  /// Level by level, so that a level's deepest point spares the next one's work.
  double run() {
    const Eigen::Vector3d lo = centre_ - Eigen::Vector3d::Constant(radius_);
    std::vector<Cube> cubes{{from_eigen(lo), 2 * radius_}}, next;
    while (!cubes.empty() && progress_.poll()) {
      next.clear();
      for (const Cube& cube : cubes) {
        for (int child = 0; child < 8; ++child) {
          const Cube octant = cube.octant(child);
          if (look(octant)) next.push_back(octant);
        }
      }
      cubes.swap(next);
    }
    return best_;
  }

 private:
  /// Does the sphere pass through the cube, where it may be deeper?
  bool look(const Cube& cube) noexcept {
    const Eigen::Vector3d away = to_eigen(cube.centre()) - centre_;
    const double distance = away.norm(), reach = cube.half_diagonal();
    if (std::fabs(distance - radius_) > reach) return false;
    const double depth = -signed_distance(field_, cube.centre());
    if (!(depth + reach > best_ + error_)) return false;
    if (distance > 0)
      best_ = std::max(best_, -signed_distance(field_, from_eigen(centre_ + away * (radius_ / distance))));
    return depth + reach > best_ + error_;
  }

  const FieldData& field_;
  Eigen::Vector3d centre_;
  double radius_, error_;
  Progress& progress_;
  double best_ = 0;
};

}  // namespace

double depth_on_sphere(const FieldData& field, const Vec3& centre, double radius, double error,
                       Progress& progress) {
  return SphereSearch(field, centre, radius, error, progress).run();
}

}  // namespace cdfr
