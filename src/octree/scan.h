/// Looks through a leaf's list in single precision for the triangles that may be closest.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "geometry/scan_group.h"
#include "octree/leaf_index.h"

namespace cdfr {

/// Groups ahead of a scan whose lines are called for.
inline constexpr std::size_t scan_ahead = 8;

/// Calls for the groups of entries first .. first + count - 1, as far as the list goes.
inline void prefetch(const ScanGroup* groups, std::span<const Entry> list, std::size_t first,
                     std::size_t count) noexcept {
  for (std::size_t i = first; i < std::min(first + count, list.size()) && list[i].is_group(); ++i) {
    prefetch(groups[list[i].number()]);
  }
}

/// Triangles that a scan has not ruled out, by slot.
struct Candidates {
  std::array<std::uint32_t, 64> slots;
  std::array<float, 64> squared;  ///< estimated, in edges
  std::uint32_t count;            ///< of the above that are set
};

/// Fills `candidates` with every triangle of the list whose computed distance from the point is least, or is
/// as small but for rounding, and with few others. False, and nothing of use in `candidates`, where the list
/// holds BVH nodes that matter or more triangles are about equally close than there is room for: then a
/// search in double answers (search.h).
///
/// The list ascends: it ends where an entry's distance from the centre exceeds the point's own by more than
/// the upper bound U on the least distance. With scan_group.h's bound, an estimate e in a group of reach D
/// says U <= (e + s D + f)(1 + 2k), k = scan_error, s = scan_share, f = scan_floor, and rules its triangle
/// out if e > (U + s D + f)(1 + 2k): then its true distance is above U. The unused half of the bound covers
/// the roundings of U and of that threshold, and with 2^-48 edges what separates computed distances that tie
/// (2^-88 of the largest coordinate, below 2^-54 edges). Which others come along differs with the instruction
/// set; they lose in double-double, so answers do not.
bool scan(const ScanGroup* groups, std::span<const Entry> list, const Vec3& point, double from_centre,
          Candidates& candidates) noexcept;

}  // namespace cdfr
