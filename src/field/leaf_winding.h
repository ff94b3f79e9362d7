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
#include <vector>

#include "cdfr/core/types.h"

namespace cdfr {

struct FieldData;

/// By leaf of the index; empty if winding does not decide.
struct LeafWindings {
  std::vector<float> at_reference;  ///< w(r), NaN where it is not known or nobody needs it

  // Empty if there is no boundary.
  struct Change {
    float gradient[3];    ///< by the boundary but for near edges
    float drift;          ///< and that at most beside, by the farthest point of the leaf
    std::uint32_t first;  ///< the leaf's near edges are near[first] .. of the next leaf
  };
  std::vector<Change> changes;
  std::vector<std::uint32_t> near;  ///< numbers of boundary edges

  std::uint64_t bytes() const noexcept;
};

/// Precondition: sides and index are set. One count of crossings or evaluation of w a leaf. Runs in the
/// caller's task arena.
LeafWindings leaf_windings(const FieldData& field);

/// 1 outside, -1 inside, 0 if p's leaf does not tell.
int side_by_leaf(const FieldData& field, const Vec3& p) noexcept;

}  // namespace cdfr
