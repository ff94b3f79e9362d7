#include "octree/influence.h"

#include <algorithm>
#include <cmath>

#include "geometry/box_distance.h"

namespace cdfr {
namespace {

constexpr double root_three_above = 1.7320508075688774;
/// Covers the few roundings, each below u, of a threshold's own arithmetic.
constexpr double up = 1 + 16 * unit_roundoff;

}  // namespace

CornerDominance::CornerDominance(const Lattice& lattice, const std::array<Vec3, 8>& corners,
                                 const Dominators& dominators) noexcept {
  const double shift = root_three_above * lattice.grown() * up;
  const double eps = estimate_error * lattice.reach();
  const double s = 2 * eps;
  for (std::size_t k = 0; k < dominator_count; ++k) {
    std::array<double, 8> away;
    double farthest = 0;
    for (std::size_t c = 0; c < 8; ++c) {
      away[c] = distance_between(corners[c], dominators[k]) * up + shift;
      farthest = std::max(farthest, away[c]);
    }
    for (std::size_t c = 0; c < 8; ++c) {
      const double needed = std::sqrt(away[c] * away[c] + 2 * s * farthest + s * s) * up + shift + eps;
      thresholds_[k][c] = needed * needed * up;
    }
  }
}

bool CornerDominance::drops(const std::array<double, 8>& squared) const noexcept {
  for (const auto& threshold : thresholds_) {
    bool all = true;
    for (std::size_t c = 0; c < 8; ++c) all &= squared[c] > threshold[c];
    if (all) return true;
  }
  return false;
}

std::uint8_t CornerDominance::keeps(const std::array<const GroupDistances*, 8>& squared) const noexcept {
  std::array<std::uint64_t, group_size> dropped{};
  for (const auto& threshold : thresholds_) {
    std::array<std::uint64_t, group_size> all;
    all.fill(1);
    for (std::size_t c = 0; c < 8; ++c) {
      for (std::size_t lane = 0; lane < group_size; ++lane)
        all[lane] &= (*squared[c])[lane] > threshold[c] ? 1U : 0U;
    }
    for (std::size_t lane = 0; lane < group_size; ++lane) dropped[lane] |= all[lane];
  }
  unsigned kept = 0;
  for (std::size_t lane = 0; lane < group_size; ++lane) kept |= (dropped[lane] == 0 ? 1U : 0U) << lane;
  return static_cast<std::uint8_t>(kept);
}

double band_threshold(const Lattice& lattice, int level, double least) noexcept {
  const double shift = root_three_above * lattice.grown() * up;
  const double eps = estimate_error * lattice.reach();
  // m is at most least + eps; the diameter of the grown cell is sqrt(3) s + 2 shift; eps again for T's own
  // estimate and for the kernel.
  const double farthest = least + root_three_above * lattice.size(level) * up + 2 * shift + 4 * eps;
  return farthest * farthest * up;
}

}  // namespace cdfr
