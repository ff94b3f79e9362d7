#include "analysis/ascent.h"

#include <algorithm>
#include <cmath>

#include "analysis/common_direction.h"
#include "core/vector.h"
#include "field/query.h"
#include "geometry/cube.h"

namespace cdfr {
namespace {

/// A way across a part of a thousand cells takes fewer.
constexpr int most_steps = 4096;

}  // namespace

double Ascent::depth_at(const Eigen::Vector3d& x) const noexcept {
  return -signed_distance(field_, from_eigen(x));
}

std::size_t Ascent::cell_at(const Eigen::Vector3d& x) const noexcept {
  const Vec3& origin = field_.tree.lattice.origin;
  const auto place = [&](double at, double from) {
    return static_cast<std::uint32_t>(std::floor((at - from) / critical_.size));
  };
  return critical_.find(
      key_of({critical_.level, {place(x.x(), origin.x), place(x.y(), origin.y), place(x.z(), origin.z)}}));
}

/// Zero where there is none.
Eigen::Vector3d Ascent::way_up(const Eigen::Vector3d& x, double depth) {
  if (!near_triangles(field_, x, critical_.size, depth, near_)) return Eigen::Vector3d::Zero();
  away_.clear();
  for (const NearTriangle& near : near_) away_.emplace_back(near.foot.gradient * near.foot.distance);
  return common_direction(away_, 0).direction;
}

std::size_t Ascent::climb(const Eigen::Vector3d& start, double depth, Progress& progress) {
  Eigen::Vector3d x = start;
  for (int step = 0; step < most_steps; ++step) {
    if (const std::size_t cell = cell_at(x); cell != CriticalCells::none) return cell;
    const Eigen::Vector3d up = way_up(x, depth);
    if (up.isZero(0) || !progress.poll()) break;
    double length = Cube{{}, critical_.size}.half_diagonal();
    double next = depth_at(x + up * length);
    if (!(next > depth)) break;
    for (double longer = 2 * length; longer < depth; longer *= 2) {
      const double there = depth_at(x + up * longer);
      if (!(there > next) || cell_at(x + up * length) != CriticalCells::none) break;
      length = longer;
      next = there;
    }
    x += up * length;
    depth = next;
  }
  return CriticalCells::none;
}

}  // namespace cdfr
