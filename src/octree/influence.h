/// THE completeness rule: which triangles a cell's list may drop.
///
/// **Corner dominance.** For a set T let f_T(P) = d(P,T)^2 - |P|^2 = min over y in T of (|y|^2 - 2 P.y): a
/// minimum of affine functions of P, so concave. For one point q, f_q is affine. So f_T - f_q is concave, and
/// on a box its least value is at a corner: if T is farther than q from all eight corners of a cell, T is
/// farther than q from every point of the cell. If q lies on the surface, T is then closest to no point of
/// the cell and leaves its list. T may be a triangle or a box of many: a BVH node leaves with one test. Any
/// surface point serves as q; the closest ones to the cell's centre and corners serve best.
///
/// **Rounding.** Complete means: for every P of the cell grown by g on each side (Lattice::grown), every
/// triangle whose *computed* squared distance is least is in the list. Let R be Lattice::reach, eps =
/// estimate_error * R. T may go if d(P,T) > |P - q| + s for all P of the grown cell, where s covers what
/// separates |P - q| from a computed least distance:
///  - q is an estimate_closest: within eps of the surface, so the true least distance is at most |P - q| +
///  eps;
///  - the kernel is within 2^-93 R of the truth, once for T and once for the winner.
/// So s = 2 eps does. Squared, with D >= |P - q| on the grown cell: d(P,T)^2 - |P - q|^2 > 2 s D + s^2
/// suffices, and by concavity it suffices at the corners C' of the grown cell. With |C' - C| <= h = sqrt(3)
/// g: d(C',T) >= d(C,T) - h and |C' - q| <= |C - q| + h. So T may go if at each corner
///     d(C,T) > sqrt((|C - q| + h)^2 + 2 s D + s^2) + h.
/// The root is at most D + s, so the square of the right side is at most |C - q|^2 + w (2 D + w) with
/// w = s + 2 h: the threshold below, which takes one root a dominator.
///
/// **Band.** The source paper's rule (papers/huang-2001, sections 3.4 and 4): keep T if its distance from the
/// centre is at most m + sqrt(3) s, m the smallest. The same slack is added.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include "cdfr/core/types.h"
#include "geometry/sample_distances.h"
#include "octree/lattice.h"

namespace cdfr {

/// Dominators of a cell: surface points close to its centre (first) and its eight corners, in child order.
inline constexpr std::size_t dominator_count = 9;
using Dominators = std::array<Vec3, dominator_count>;

/// By dominator, then by corner.
using DominanceThresholds = std::array<std::array<double, 8>, dominator_count>;

/// Thresholds for one cell on squared distances from its corners, or lower bounds on them.
class CornerDominance {
 public:
  CornerDominance() = default;
  CornerDominance(const Lattice& lattice, const std::array<Vec3, 8>& corners,
                  const Dominators& dominators) noexcept;

  /// True if something whose squared distances from the corners are at least these wins nowhere in the cell.
  bool drops(const std::array<double, 8>& squared) const noexcept;
  const DominanceThresholds& thresholds() const noexcept { return thresholds_; }

 private:
  DominanceThresholds thresholds_{};
};

/// What is left of a group in one child: at first nothing.
struct KeptLanes {
  static constexpr double infinite = std::numeric_limits<double>::infinity();
  std::uint8_t lanes = 0;           ///< bit i: triangle i may win
  std::uint8_t count = 0;           ///< of set bits
  double least_squared = infinite;  ///< from the child's centre, over these lanes
  /// The same from its corners.
  std::array<double, 8> corners_squared{infinite, infinite, infinite, infinite,
                                        infinite, infinite, infinite, infinite};
};

/// Tests the given lanes of a group against the rules of the given children (bits too), all triangles at
/// once.
void sift_lanes(const std::array<CornerDominance, 8>& rules, const SampleDistances& distances,
                std::uint8_t lanes, unsigned children, std::array<KeptLanes, 8>& kept) noexcept;

/// Threshold of the band rule on squared estimates from the centre. `least` is an estimate of the smallest
/// distance from it.
double band_threshold(const Lattice& lattice, int level, double least) noexcept;

}  // namespace cdfr
