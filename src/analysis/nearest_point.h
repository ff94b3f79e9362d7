/// The nearest of many points, by a balanced tree of them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "cdfr/core/types.h"

namespace cdfr {

/// A k-d tree (Bentley, "Multidimensional binary search trees used for associative searching", 1975) that
/// lies in an array: the middle point of a range halves it, along the axes in turn.
class PointTree {
 public:
  /// O(n log n). Precondition: not empty; `points` outlive this.
  explicit PointTree(std::span<const Vec3> points);

  /// Number of the nearest point by rounded squared distance; of equally near ones the lowest. O(log n) as a
  /// rule.
  std::uint32_t nearest(const Vec3& x) const noexcept;

 private:
  struct Best {
    double squared;
    std::uint32_t number;
  };
  void look(std::size_t first, std::size_t end, int axis, const Vec3& x, Best& best) const noexcept;

  std::span<const Vec3> points_;
  std::vector<std::uint32_t> order_;
};

}  // namespace cdfr
