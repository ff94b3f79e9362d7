#include "octree/influence.h"

#include <cmath>

// Compiled once for each instruction set. Comparisons give the same bits from every set.
#undef HWY_DISABLED_TARGETS
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "octree/influence.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace cdfr {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Tag = hn::CappedTag<double, group_size>;

/// Lanes first .. first + Lanes - 1 of a group, added to what is kept.
HWY_INLINE void sift(const DominanceThresholds& thresholds, const SampleDistances& distances,
                     std::size_t child, std::size_t first, std::uint8_t lanes, KeptLanes& kept) {
  const Tag d;
  hn::Vec<Tag> from[8];
  for (std::size_t c = 0; c < 8; ++c) {
    from[c] = hn::Load(d, distances.squared[corner_sample(child, c)].data() + first);
  }
  std::uint8_t bits[8] = {static_cast<std::uint8_t>(lanes >> first)};  // Highway stores up to eight bytes
  auto left = hn::LoadMaskBits(d, bits);
  for (const std::array<double, 8>& threshold : thresholds) {
    auto dropped = hn::Gt(from[0], hn::Set(d, threshold[0]));
    for (std::size_t c = 1; c < 8; ++c) {
      dropped = hn::And(dropped, hn::Gt(from[c], hn::Set(d, threshold[c])));
    }
    left = hn::AndNot(dropped, left);
    if (hn::AllFalse(d, left)) return;
  }
  const auto centre = hn::Load(d, distances.squared[centre_sample(child)].data() + first);
  const double least = hn::GetLane(hn::MinOfLanes(d, hn::IfThenElse(left, centre, hn::Inf(d))));
  kept.least_squared = least < kept.least_squared ? least : kept.least_squared;
  for (std::size_t c = 0; c < 8; ++c) {
    const double from_corner = hn::GetLane(hn::MinOfLanes(d, hn::IfThenElse(left, from[c], hn::Inf(d))));
    double& closest = kept.corners_squared[c];
    closest = from_corner < closest ? from_corner : closest;
  }
  kept.count = static_cast<std::uint8_t>(kept.count + hn::CountTrue(d, left));
  hn::StoreMaskBits(d, left, bits);
  kept.lanes = static_cast<std::uint8_t>(kept.lanes | bits[0] << first);
}

void sift_lanes_here(const std::array<CornerDominance, 8>& rules, const SampleDistances& distances,
                     std::uint8_t lanes, unsigned children, std::array<KeptLanes, 8>& kept) {
  for (std::size_t child = 0; child < 8; ++child) {
    kept[child] = {};
    if ((children >> child & 1U) == 0) continue;
    for (std::size_t first = 0; first < group_size; first += hn::Lanes(Tag())) {
      sift(rules[child].thresholds(), distances, child, first, lanes, kept[child]);
    }
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace cdfr
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include <algorithm>

#include "geometry/box_distance.h"

namespace cdfr {

HWY_EXPORT(sift_lanes_here);

namespace {

constexpr double root_three_above = 1.7320508075688774;
/// Covers the few roundings, each below u, of a threshold's own arithmetic.
constexpr double up = 1 + 16 * unit_roundoff;

}  // namespace

CornerDominance::CornerDominance(const Lattice& lattice, const std::array<Vec3, 8>& corners,
                                 const Dominators& dominators) noexcept {
  const double shift = root_three_above * lattice.grown() * up;
  const double w = (2 * estimate_error * lattice.reach() + 2 * shift) * up;
  for (std::size_t k = 0; k < dominator_count; ++k) {
    const Vec3& q = dominators[k];
    std::array<double, 8>& threshold = thresholds_[k];
    double farthest = 0;
    for (std::size_t c = 0; c < 8; ++c) {
      const double x = corners[c].x - q.x, y = corners[c].y - q.y, z = corners[c].z - q.z;
      threshold[c] = (x * x + y * y + z * z) * up;
      farthest = std::max(farthest, threshold[c]);
    }
    const double away = std::sqrt(farthest) * up + shift;
    const double slack = w * (2 * away + w);
    for (double& t : threshold) t = (t + slack) * up;
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

void sift_lanes(const std::array<CornerDominance, 8>& rules, const SampleDistances& distances,
                std::uint8_t lanes, unsigned children, std::array<KeptLanes, 8>& kept) noexcept {
  HWY_DYNAMIC_DISPATCH(sift_lanes_here)(rules, distances, lanes, children, kept);
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
#endif
