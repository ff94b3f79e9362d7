/// The cubes that a contour may pass through, one after another: pieces of leaves, then of the space beyond
/// the octree.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>

#include "contour/cube.h"
#include "contour/level.h"
#include "core/progress.h"
#include "field/field_data.h"

namespace cdfr {

/// A cube to descend into. Pieces of one leaf carry the same number, counted among visited leaves, and its
/// list; no_leaf beyond the domain, and no list.
struct Region {
  Cube cube;
  std::uint64_t leaf = 0;
  std::span<const Entry> list;
  Side side = Side::undecided;

  static constexpr std::uint64_t no_leaf = ~std::uint64_t{0};
};

/// Halvings that a region leaves to its descent: bounds the points that one region can give.
inline constexpr int region_depth = 6;

struct RegionCounts {
  std::uint64_t visited = 0;  ///< leaves whose centre's value allows the contour
  std::uint64_t evaluations = 0;
};

/// Calls take(region) in Morton order, leaves first, until it returns false. Leaves are tested in parallel,
/// those visited are kept.
RegionCounts for_each_region(const FieldData& field, const Level& level, Progress& progress,
                             const std::function<bool(const Region&)>& take);

}  // namespace cdfr
