#include "analysis/triangle_edges.h"

#include <algorithm>
#include <numeric>

namespace cdfr {
namespace {

template <class Visit>
void for_each_side(const TriangleStore& triangles, Visit visit) {
  for (std::uint32_t slot = 0; slot < triangles.size(); ++slot) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t edge = triangles.records[slot].edges[k];
      if (edge != no_index) visit(edge, TriangleSide{slot, k});
    }
  }
}

}  // namespace

TriangleEdges::TriangleEdges(const TriangleStore& triangles) {
  std::uint64_t edges = 0;
  for_each_side(triangles,
                [&](std::uint64_t edge, const TriangleSide&) { edges = std::max(edges, edge + 1); });
  starts_.assign(edges + 1, 0);
  for_each_side(triangles, [&](std::uint32_t edge, const TriangleSide&) { ++starts_[edge + 1]; });
  std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
  sides_.resize(starts_.back());
  std::vector<std::uint64_t> next = starts_;
  for_each_side(triangles,
                [&](std::uint32_t edge, const TriangleSide& side) { sides_[next[edge]++] = side; });
}

std::vector<std::uint32_t> slots_by_number(const TriangleStore& triangles) {
  std::vector<std::uint32_t> slots(triangles.size());
  for (std::uint32_t slot = 0; slot < triangles.size(); ++slot) slots[triangles.records[slot].number] = slot;
  return slots;
}

}  // namespace cdfr
