/// Which triangles of a field meet at each of its edges.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/triangles.h"

namespace cdfr {

/// One side of a triangle: side k runs from its corner k to (k + 1) % 3.
struct TriangleSide {
  std::uint32_t slot;
  std::uint32_t side;
};

class TriangleEdges {
 public:
  /// O(triangles).
  explicit TriangleEdges(const TriangleStore& triangles);

  std::uint32_t count() const noexcept { return static_cast<std::uint32_t>(starts_.size() - 1); }
  /// Ascending by slot.
  std::span<const TriangleSide> at(std::uint32_t edge) const noexcept {
    return std::span(sides_).subspan(starts_[edge], starts_[edge + 1] - starts_[edge]);
  }

 private:
  std::vector<std::uint64_t> starts_;
  std::vector<TriangleSide> sides_;
};

/// Slots by triangle number.
std::vector<std::uint32_t> slots_by_number(const TriangleStore& triangles);

}  // namespace cdfr
