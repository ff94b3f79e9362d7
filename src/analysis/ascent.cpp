#include "analysis/ascent.h"

#include <algorithm>
#include <cmath>

#include "analysis/common_direction.h"
#include "analysis/critical_cells.h"
#include "core/vector.h"
#include "field/query.h"

namespace cdfr {
namespace {

/// A way across a part of a thousand cells takes fewer.
constexpr int most_steps = 4096;
/// Of a step, beside a critical point.
constexpr int most_halvings = 6;

}  // namespace

double Ascent::depth_at(const Eigen::Vector3d& x) const noexcept {
  return -signed_distance(field_, from_eigen(x));
}

std::size_t Ascent::cell_at(const CriticalCells& critical, const Eigen::Vector3d& x) const noexcept {
  const Vec3& origin = field_.tree.lattice.origin;
  const auto place = [&](double at, double from) {
    return static_cast<std::uint32_t>(std::floor((at - from) / critical.size));
  };
  return critical.find(
      {critical.level, {place(x.x(), origin.x), place(x.y(), origin.y), place(x.z(), origin.z)}});
}

/// The way on from x, for a step of that length; zero where there is none. What can be closest within the
/// step can be so in the cube of twice its size.
Eigen::Vector3d Ascent::way_up(const Eigen::Vector3d& x, double depth, double step) {
  if (!near_triangles(field_, x, 2 * step, depth, near_)) return Eigen::Vector3d::Zero();
  return away_from_near();
}

Eigen::Vector3d Ascent::away_from_near() {
  away_.clear();
  for (const NearTriangle& near : near_) away_.emplace_back(near.foot.gradient * near.foot.distance);
  return common_direction(away_, 0).direction;
}

/// From x one step on, the shorter the closer x is to being critical. False where no step goes up.
bool Ascent::step_up(const CriticalCells& critical, Eigen::Vector3d& x, double& depth) {
  for (int halving = 0; halving <= most_halvings; ++halving) {
    double length = std::ldexp(critical.size, -halving);
    const Eigen::Vector3d up = way_up(x, depth, length);
    if (up.isZero(0)) continue;
    double next = depth_at(x + up * length);
    if (!(next > depth)) continue;
    for (double longer = 2 * length; longer < depth; longer *= 2) {
      if (cell_at(critical, x + up * length) != CriticalCells::none) break;
      const double there = depth_at(x + up * longer);
      if (!(there > next)) break;
      length = longer;
      next = there;
    }
    x += up * length;
    depth = next;
    return true;
  }
  return false;
}

std::size_t Ascent::climb(const CriticalCells& critical, const Vec3& start, double depth,
                          Progress& progress) {
  Eigen::Vector3d x = to_eigen(start);
  for (int step = 0; step < most_steps && progress.poll(); ++step) {
    if (const std::size_t cell = cell_at(critical, x); cell != CriticalCells::none) return cell;
    if (!step_up(critical, x, depth)) break;
  }
  return CriticalCells::none;
}

Vec3 Ascent::top_in(const Cube& cube, double depth, double shortest, std::span<const std::uint32_t> among) {
  const Eigen::Vector3d centre = to_eigen(cube.centre());
  Eigen::Vector3d x = centre;
  for (double length = cube.size / 2; length >= shortest; length /= 2) {
    near_triangles(field_, x, 2 * length, among, near_);
    const Eigen::Vector3d there = x + away_from_near() * length;
    if ((there - centre).lpNorm<Eigen::Infinity>() > cube.size / 2) continue;
    const double next = depth_at(there);
    if (!(next > depth)) continue;
    x = there;
    depth = next;
  }
  return from_eigen(x);
}

}  // namespace cdfr
