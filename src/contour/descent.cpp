#include "contour/descent.h"

#include <cmath>
#include <limits>

#include "contour/exclusion.h"
#include "core/vector.h"

namespace cdfr {
namespace {

/// How often a sub-voxel whose point cannot be placed is halved, and how many samples it is worth, before it
/// counts as undecided.
constexpr int most_halvings = 10;
constexpr int most_trials = 4096;

double distance_apart(const Vec3& a, const Vec3& b) noexcept { return (to_eigen(a) - to_eigen(b)).norm(); }

}  // namespace

Sample Descent::sample(const Vec3& x) noexcept {
  ++counts_.evaluations;
  return sample_at(field_, level_, x);
}

void Descent::run(const Cube& cube) {
  if (cube.half_diagonal() <= tolerance_ / 2) {
    finish(cube);
    return;
  }
  for (int child = 0; child < 8; ++child) {
    const Cube octant = cube.octant(child);
    if (octant.half_diagonal() <= tolerance_ / 2) {
      finish(octant);
      continue;
    }
    ++counts_.evaluations;
    if (passes(level_, value_at(field_, level_, octant.centre()), octant)) run(octant);
  }
}

/// A cube of the final size.
void Descent::finish(const Cube& cube) {
  const Sample centre = sample(cube.centre());
  if (!passes(level_, centre.value, cube) || put_point(centre, cube)) return;
  Stuck stuck{cube, 0, false, true, centre.value, centre};
  halve(cube, most_halvings, stuck);
  if (stuck.found || stuck.excluded) return;
  ++counts_.undecided;
  const Sample& at = stuck.closest;
  points_.push_back({at.position, at.gradient, at.triangle, std::numeric_limits<double>::infinity()});
}

bool Descent::put_point(const Sample& at, const Cube& within) {
  if (level_.height == 0) return put(at.foot, at, level_.rounding, within);
  if (at.value < level_.height) return put_away(at, within);
  const Eigen::Vector3d foot = to_eigen(at.foot);
  const Eigen::Vector3d offset = to_eigen(at.position) - foot;
  return put(from_eigen(foot + offset * (level_.height / at.value)), at, level_.rounding, within);
}

bool Descent::put_away(const Sample& at, const Cube& within) {
  const Eigen::Vector3d foot = to_eigen(at.foot);
  // The gradient of the signed distance points along the ray on either side of the surface, outward; `side`
  // turns it.
  const Eigen::Vector3d direction = to_eigen(at.gradient) * level_.side;
  const double hair = 2 * level_.rounding;
  const Sample beyond = sample(from_eigen(foot + direction * (level_.height + hair)));
  if (beyond.value < level_.height + level_.rounding) return false;
  return put(from_eigen(foot + direction * level_.height), at, hair + level_.rounding, within);
}

/// A point serves a cube if it is within E/2 of the centre: then it is within E of all of the cube.
bool Descent::put(const Vec3& position, const Sample& from, double error, const Cube& within) {
  if (distance_apart(position, within.centre()) > tolerance_ / 2 + level_.rounding) return false;
  points_.push_back({position, from.gradient, from.triangle, error});
  return true;
}

bool Descent::try_sample(const Vec3& x, Stuck& stuck) {
  const Sample at = sample(x);
  ++stuck.trials;
  stuck.last = at.value;
  if (std::fabs(at.value - level_.height) < std::fabs(stuck.closest.value - level_.height))
    stuck.closest = at;
  stuck.found = put_point(at, stuck.cube);
  return stuck.found;
}

bool Descent::try_corners(const Cube& piece, Stuck& stuck) {
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 x{piece.lo.x + (corner & 1 ? piece.size : 0), piece.lo.y + (corner & 2 ? piece.size : 0),
                 piece.lo.z + (corner & 4 ? piece.size : 0)};
    if (try_sample(x, stuck)) return true;
  }
  return false;
}

/// Depth first, until a point is found or all is excluded.
void Descent::halve(const Cube& piece, int times, Stuck& stuck) {
  const double most = distance_above(field_, piece.lo, piece.size) + level_.rounding;
  if (most < level_.height) return;
  if (try_corners(piece, stuck)) return;
  // No sample can tell a largest value from the height by less than rounding.
  const bool hopeless = most - stuck.closest.value < 4 * level_.rounding;
  if (times == 0 || hopeless || stuck.trials >= most_trials) {
    stuck.excluded = false;
    return;
  }
  for (int child = 0; child < 8; ++child) {
    const Cube octant = piece.octant(child);
    if (try_sample(octant.centre(), stuck)) return;
    if (!passes(level_, stuck.last, octant)) continue;
    halve(octant, times - 1, stuck);
    if (stuck.found || (!stuck.excluded && stuck.trials >= most_trials)) return;
  }
}

}  // namespace cdfr
