#include "analysis/common_direction.h"

#include <algorithm>

namespace cdfr {
namespace {

/// After so many steps what is left to win is a small share of the hull's width.
constexpr int most_steps = 48;

const Eigen::Vector3d& least_along(std::span<const Eigen::Vector3d> vectors,
                                   const Eigen::Vector3d& x) noexcept {
  return *std::min_element(vectors.begin(), vectors.end(),
                           [&](const auto& a, const auto& b) { return a.dot(x) < b.dot(x); });
}

}  // namespace

CommonDirection common_direction(std::span<const Eigen::Vector3d> vectors, double enough) noexcept {
  CommonDirection best;
  if (vectors.empty()) return best;
  Eigen::Vector3d x = vectors.front();
  for (int step = 0; step < most_steps; ++step) {
    const double norm = x.norm();
    if (!(norm > 0) || norm <= enough) break;
    const Eigen::Vector3d direction = x / norm;
    const Eigen::Vector3d& support = least_along(vectors, direction);
    const double least = support.dot(direction);
    if (least > best.least) best = {direction, least};
    if (best.least > enough) break;
    const Eigen::Vector3d way = support - x;
    const double square = way.squaredNorm();
    if (!(square > 0)) break;
    x += way * std::clamp(-x.dot(way) / square, 0.0, 1.0);
  }
  return best;
}

}  // namespace cdfr
