#include "contour/descent.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/vector.h"
#include "field/distance_above.h"

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
  if (level_.is_final(cube.half_diagonal())) return finish(cube);
  for (int child = 0; child < 8; ++child) {
    const Cube octant = cube.octant(child);
    if (level_.is_final(octant.half_diagonal())) {
      finish(octant);
      continue;
    }
    ++counts_.evaluations;
    if (passes(level_, value_at(field_, level_, octant.centre()), octant)) run(octant);
  }
}

void Descent::finish(const Cube& cube) {
  missed_ = -std::numeric_limits<double>::infinity();
  const Sample centre = sample(cube.centre());
  if (!passes(level_, centre.value, cube)) return;
  if (level_.rule == Rule::paper) return put_centre(centre);
  if (put_point(centre, cube)) return;
  if (!centre.on_side && off_side(cube, centre.value)) return;
  Stuck stuck{cube, centre, centre};
  // Where the sign jumps, the centre may be above the height, its point on the wrong side.
  if (centre.value >= level_.height) stuck.highest.value = -std::numeric_limits<double>::infinity();
  halve(cube, most_halvings, stuck);
  if (stuck.found || stuck.excluded || put_from_highest(stuck)) return;
  ++counts_.undecided;
  const Sample& at = stuck.highest;
  points_.push_back({at.position, at.gradient, at.triangle, std::numeric_limits<double>::infinity()});
}

void Descent::put_centre(const Sample& at) {
  if (level_.jumps && !at.on_side) return;
  const double beyond = at.value - level_.height;
  points_.push_back({at.position, at.gradient, at.triangle,
                     beyond >= 0 ? beyond + level_.rounding : std::numeric_limits<double>::infinity()});
}

bool Descent::put_point(const Sample& at, const Cube& within) {
  if (level_.height == 0) return put(at.foot, at, level_.rounding, within);
  if (at.value < level_.height) return put_away(at, within);
  const Eigen::Vector3d foot = to_eigen(at.foot);
  const Eigen::Vector3d offset = to_eigen(at.position) - foot;
  return put(from_eigen(foot + offset * (level_.height / at.value)), at, level_.rounding, within);
}

/// The gradient of the signed distance points along the ray on either side of the surface, outward; `side`
/// turns it. Where the sign jumps the contour may be on either side of the surface.
bool Descent::put_away(const Sample& at, const Cube& within) {
  const Eigen::Vector3d direction = to_eigen(at.gradient) * level_.side;
  return put_along(at, from_eigen(direction), within) ||
         (level_.jumps && put_along(at, from_eigen(-direction), within));
}

bool Descent::put_along(const Sample& at, const Vec3& along, const Cube& within) {
  const Eigen::Vector3d foot = to_eigen(at.foot);
  const Eigen::Vector3d direction = to_eigen(along);
  const double hair = 2 * level_.rounding;
  const Sample beyond = sample(from_eigen(foot + direction * (level_.height + hair)));
  if (beyond.value < level_.height + level_.rounding) return put_at_sheet(at, along, beyond, within);
  return put(from_eigen(foot + direction * level_.height), at, hair + level_.rounding, within);
}

/// The ray from the foot has crossed a medial sheet. Up to there the value is its length; beyond, it changes
/// by what the gradient says, and both are equal at the sheet. If that is at the height to the last bits, the
/// value there tells as well as any whether the contour is.
bool Descent::put_at_sheet(const Sample& at, const Vec3& along, const Sample& beyond, const Cube& within) {
  const Eigen::Vector3d direction = to_eigen(along);
  const double length = level_.height + 2 * level_.rounding;
  const double slope = level_.side * to_eigen(beyond.gradient).dot(direction);
  const double sheet = (beyond.value - slope * length) / (1 - slope);
  if (level_.jumps || !(sheet >= level_.height - 4 * level_.rounding && sheet <= length)) return false;
  const Sample peak = sample(from_eigen(to_eigen(at.foot) + direction * sheet));
  missed_ = std::max({missed_, beyond.value, peak.value});
  return peak.value >= level_.height && put_between(at, peak, within);
}

/// A point serves a cube if it is within E/2 of the centre: then it is within E of all of the cube.
bool Descent::put(const Vec3& position, const Sample& from, double error, const Cube& within) {
  if (distance_apart(position, within.centre()) > level_.tolerance / 2 + 16 * level_.rounding) return false;
  if (level_.jumps && level_.height > 0) {
    const Sample here = sample(position);
    if (here.on_side) points_.push_back({position, here.gradient, here.triangle, error});
    return here.on_side;
  }
  points_.push_back({position, from.gradient, from.triangle, error});
  return true;
}

bool Descent::try_sample(const Vec3& x, Stuck& stuck) {
  const Sample at = sample(x);
  ++stuck.trials;
  stuck.last = at.value;
  if (at.value < level_.height && at.value > stuck.highest.value) stuck.highest = at;
  const bool crosses = stuck.centre.value < level_.height && at.value >= level_.height;
  stuck.found = put_point(at, stuck.cube) || (crosses && put_between(stuck.centre, at, stuck.cube));
  return stuck.found;
}

/// The value crosses the height between the two samples: halved to where it does.
bool Descent::put_between(const Sample& below, const Sample& above, const Cube& within) {
  Eigen::Vector3d low = to_eigen(below.position);
  Sample high = above;
  double apart = 0;
  for (;;) {
    apart = (to_eigen(high.position) - low).norm();
    if (apart <= level_.rounding) break;
    const Sample middle = sample(from_eigen((low + to_eigen(high.position)) / 2));
    if (middle.value < level_.height) {
      low = to_eigen(middle.position);
    } else {
      high = middle;
    }
  }
  return put(high.position, high, apart + level_.rounding, within);
}

/// Where the contour touches the cube from outside, the highest sample is at height but for rounding: a hair
/// farther, in one of 26 directions, the value is above it.
bool Descent::put_from_highest(const Stuck& stuck) {
  const double hair = 8 * level_.rounding;
  if (stuck.highest.value < level_.height - hair) return false;
  for (int direction = 0; direction < 27; ++direction) {
    const Eigen::Vector3d step(direction % 3 - 1, direction / 3 % 3 - 1, direction / 9 - 1);
    const Sample at = sample(from_eigen(to_eigen(stuck.highest.position) + hair * step));
    if (at.value >= level_.height && put_between(stuck.highest, at, stuck.cube)) return true;
  }
  return false;
}

bool Descent::try_corners(const Cube& piece, Stuck& stuck) {
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 x{piece.lo.x + (corner & 1 ? piece.size : 0), piece.lo.y + (corner & 2 ? piece.size : 0),
                 piece.lo.z + (corner & 4 ? piece.size : 0)};
    if (try_sample(x, stuck)) return true;
  }
  return false;
}

/// True if the sign jumps and all of the cube is certainly on the other side. `value` is that of its centre:
/// beyond the half diagonal no triangle comes in.
bool Descent::off_side(const Cube& cube, double value) const noexcept {
  if (!level_.jumps || level_.height == 0) return false;
  const double radius = cube.half_diagonal() + level_.rounding;
  if (!(value > radius)) return false;
  return side_of_ball(field_.winding, field_.space(), cube.centre(), radius) == level_.other_side();
}

/// Depth first, until a point is found or all is excluded.
void Descent::halve(const Cube& piece, int times, Stuck& stuck) {
  const double most = distance_above(field_, piece.lo, piece.size) + level_.rounding;
  if (most < level_.height) return;
  if (try_corners(piece, stuck)) return;
  // No sample can tell a largest value from the height by less than rounding: neither one in the cube, nor
  // those at a sheet that points crossed on their way to the height.
  const bool hopeless = std::min(most - stuck.highest.value, most - missed_) < 4 * level_.rounding;
  if (times == 0 || hopeless || stuck.trials >= most_trials) {
    stuck.excluded = false;
    return;
  }
  for (int child = 0; child < 8; ++child) {
    const Cube octant = piece.octant(child);
    if (try_sample(octant.centre(), stuck)) return;
    if (!passes(level_, stuck.last, octant) || off_side(octant, stuck.last)) continue;
    halve(octant, times - 1, stuck);
    if (stuck.found || (!stuck.excluded && stuck.trials >= most_trials)) return;
  }
}

}  // namespace cdfr
