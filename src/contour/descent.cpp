#include "contour/descent.h"

#include <cmath>
#include <limits>

#include "contour/exclusion.h"
#include "core/vector.h"

namespace cdfr {
namespace {

/// How often a sub-voxel whose point cannot be placed is halved before it counts as undecided.
constexpr int most_halvings = 10;

}  // namespace

bool Descent::passes(double value, const Cube& cube) const noexcept {
  return std::fabs(value - level_.height) <= cube.half_diagonal() + level_.rounding;
}

double Descent::value_at_centre(const Cube& cube) noexcept {
  ++counts_.evaluations;
  return value_at(field_, level_, cube.centre());
}

Sample Descent::sample(const Vec3& x) noexcept {
  ++counts_.evaluations;
  return sample_at(field_, level_, x);
}

void Descent::run(const Cube& cube) {
  if (!passes(value_at_centre(cube), cube)) return;
  const std::size_t before = points_.size();
  ++counts_.visited;
  descend(cube);
  counts_.productive += points_.size() > before;
}

/// Precondition: the cube passes.
void Descent::descend(const Cube& cube) {
  if (cube.half_diagonal() <= tolerance_ / 2) {
    finish(cube);
    return;
  }
  for (int child = 0; child < 8; ++child) {
    const Cube octant = cube.octant(child);
    if (octant.half_diagonal() <= tolerance_ / 2) {
      finish(octant);
    } else if (passes(value_at_centre(octant), octant)) {
      descend(octant);
    }
  }
}

/// A cube of the final size.
void Descent::finish(const Cube& cube) {
  const Sample centre = sample(cube.centre());
  if (!passes(centre.value, cube) || put_point(centre)) return;
  divide(cube, most_halvings);
}

bool Descent::put_point(const Sample& at) {
  if (level_.height == 0) {
    put(at.foot, at.gradient, at.triangle, level_.rounding);
    return true;
  }
  if (at.value < level_.height) return put_away(at);
  put_toward(at);
  return true;
}

void Descent::put_toward(const Sample& at) {
  const double share = at.value > 0 ? level_.height / at.value : 0;
  const Eigen::Vector3d foot = to_eigen(at.foot);
  put(from_eigen(foot + (to_eigen(at.position) - foot) * share), at.gradient, at.triangle, level_.rounding);
}

bool Descent::put_away(const Sample& at) {
  const Eigen::Vector3d foot = to_eigen(at.foot);
  // The gradient of the signed distance points along the ray on either side of the surface, outward; `side`
  // turns it.
  const Eigen::Vector3d direction = to_eigen(at.gradient) * level_.side;
  const double hair = 2 * level_.rounding;
  const Sample beyond = sample(from_eigen(foot + direction * (level_.height + hair)));
  if (beyond.value < level_.height + level_.rounding) return false;
  put(from_eigen(foot + direction * level_.height), at.gradient, at.triangle, hair + level_.rounding);
  return true;
}

bool Descent::put_from_corner(const Cube& cube) {
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 lo = cube.octant(corner).lo;
    const double half = cube.size / 2;
    const Vec3 x{lo.x + (corner & 1 ? half : 0), lo.y + (corner & 2 ? half : 0),
                 lo.z + (corner & 4 ? half : 0)};
    const Sample at = sample(x);
    if (at.value < level_.height) continue;
    put_toward(at);
    return true;
  }
  return false;
}

/// Precondition: nothing was found from the cube's centre.
void Descent::divide(const Cube& cube, int times) {
  if (distance_above(field_, cube.lo, cube.size) + level_.rounding < level_.height) return;
  if (times == 0) {
    const Sample centre = sample(cube.centre());
    ++counts_.undecided;
    put(centre.position, centre.gradient, centre.triangle, std::numeric_limits<double>::infinity());
    return;
  }
  for (int child = 0; child < 8; ++child) {
    const Cube octant = cube.octant(child);
    const Sample centre = sample(octant.centre());
    if (!passes(centre.value, octant) || put_point(centre) || put_from_corner(octant)) continue;
    divide(octant, times - 1);
  }
}

void Descent::put(const Vec3& position, const Vec3& normal, std::uint32_t triangle, double error) {
  points_.push_back({position, normal, triangle, error});
}

}  // namespace cdfr
