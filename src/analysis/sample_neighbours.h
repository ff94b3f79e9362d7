/// Which samples of a surface are connected.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "analysis/triangle_edges.h"
#include "cdfr/analysis/thickness.h"
#include "mesh/triangles.h"

namespace cdfr {

/// One more than the largest welded vertex id.
std::size_t vertex_count(const TriangleStore& triangles) noexcept;

/// The welded vertex of the triangle's corner that is there. Precondition: there is one.
std::uint32_t vertex_of(const TriangleStore& triangles, std::uint32_t slot, const Vec3& position) noexcept;

/// Which samples are neighbours: at vertices those that an edge joins; else those of one triangle, and of two
/// triangles that share an edge.
class SampleNeighbours {
 public:
  /// `slots` by triangle number. All borrowed.
  SampleNeighbours(const TriangleStore& triangles, const TriangleEdges& edges,
                   std::span<const std::uint32_t> slots, SampleAt at) noexcept
      : triangles_(triangles), edges_(edges), slots_(slots), at_(at) {}

  /// Groups of connected ones among the numbered samples; groups by their first sample, each ascending.
  /// `numbers` ascend. O(triangles).
  std::vector<std::vector<std::uint32_t>> groups(std::span<const ThicknessSample> samples,
                                                 std::span<const std::uint32_t> numbers) const;

 private:
  std::uint32_t carrier(const ThicknessSample& sample) const noexcept;

  const TriangleStore& triangles_;
  const TriangleEdges& edges_;
  std::span<const std::uint32_t> slots_;
  SampleAt at_;
};

}  // namespace cdfr
