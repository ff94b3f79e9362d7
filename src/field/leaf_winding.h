/// The winding number by leaf: known at one point of each leaf that is not all on one side, so that a query
/// counts crossings and corrects for the boundary within its leaf, instead of all along a ray.
///
/// A leaf's list holds every triangle that meets the leaf: on such a triangle nothing is closer than it. So
/// the segment from a query p to the leaf's reference point r passes through triangles of the list alone, n
/// times (SegmentCrossings), and
///     w(p) = w(r) + n + sum of near boundary edges' swept angles / 4 pi, within the drift of the others
/// (boundary.h: the change of w but for crossings hangs on the boundary alone). Without boundary that is
/// exact.
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
  std::vector<float> doubts;            ///< drift of all but the near edges, and the error of w(r)
  std::vector<std::uint32_t> first;     ///< the leaf's near edges are near[first[i]] ..
  std::vector<std::uint32_t> near;      ///< numbers of boundary edges

  std::uint64_t bytes() const noexcept;
};

/// Precondition: sides and index are set. One count of crossings or evaluation of w a leaf. Runs in the
/// caller's task arena.
LeafWindings leaf_windings(const FieldData& field);

/// 1 outside, -1 inside, 0 if p's leaf does not tell.
int side_by_leaf(const FieldData& field, const Vec3& p) noexcept;

}  // namespace cdfr
