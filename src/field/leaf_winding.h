/// The winding number by leaf: known at one point of each leaf that is not all on one side, so that a query
/// counts crossings and corrects for the boundary within its leaf, instead of all along a ray.
///
/// A leaf's list holds every triangle that meets the leaf: on such a triangle nothing is closer than it. So
/// the segment from a query p to the leaf's reference point r passes through triangles of the list alone, n
/// times (SegmentCrossings), and
///     w(p) = w(r) + n + what the boundary changes on the way (boundary.h),
/// which is exact if there is no boundary.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "cdfr/core/types.h"
#include "core/progress.h"

namespace cdfr {

struct FieldData;

/// Empty if winding does not decide.
struct LeafWindings {
  static constexpr std::int32_t unknown = std::numeric_limits<std::int32_t>::min();

  /// If there is no boundary: w(r) by leaf of the index, where it is known and somebody needs it.
  std::vector<std::int32_t> whole;

  // If there is one.
  struct Known {
    float at_reference;   ///< w(r)
    float gradient[3];    ///< by the boundary but for near edges, a radius of the leaf's ball
    float drift;          ///< and that at most beside, by the farthest point of the leaf
    std::uint32_t first;  ///< its near edges are near[first] .. of the next one
  };
  std::vector<std::uint32_t> place;  ///< by leaf: in `known`, or no_index
  std::vector<Known> known;          ///< and an end
  std::vector<std::uint32_t> near;   ///< numbers of boundary edges

  std::uint64_t bytes() const noexcept;
};

/// Precondition: sides and index are set. A query, a count of crossings or an evaluation of w a leaf. Runs in
/// the caller's task arena and polls the progress; of no use if that is cancelled.
LeafWindings leaf_windings(const FieldData& field, Progress& progress);

/// 1 outside, -1 inside, 0 if p's leaf does not tell.
int side_by_leaf(const FieldData& field, const Vec3& p) noexcept;

}  // namespace cdfr
