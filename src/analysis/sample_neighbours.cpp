#include "analysis/sample_neighbours.h"

#include <algorithm>
#include <cstddef>
#include <unordered_map>

#include "mesh/disjoint_sets.h"

namespace cdfr {

std::size_t vertex_count(const TriangleStore& triangles) noexcept {
  std::uint32_t largest = 0;
  for (const TriangleRecord& record : triangles.records)
    largest = std::max({largest, record.vertices[0], record.vertices[1], record.vertices[2]});
  return std::size_t{largest} + 1;
}

std::uint32_t vertex_of(const TriangleStore& triangles, std::uint32_t slot, const Vec3& position) noexcept {
  const auto& corners = triangles.shape(slot).vertices;
  const std::size_t k = corners[0] == position ? 0U : corners[1] == position ? 1U : 2U;
  return triangles.records[slot].vertices[k];
}

std::uint32_t SampleNeighbours::carrier(const ThicknessSample& sample) const noexcept {
  const std::uint32_t slot = slots_[sample.triangle];
  return at_ == SampleAt::vertices ? vertex_of(triangles_, slot, sample.position) : slot;
}

std::vector<std::vector<std::uint32_t>> SampleNeighbours::groups(
    std::span<const ThicknessSample> samples, std::span<const std::uint32_t> numbers) const {
  const std::size_t carriers = at_ == SampleAt::vertices ? vertex_count(triangles_) : triangles_.size();
  std::vector<std::uint8_t> chosen(carriers, 0);
  for (const std::uint32_t i : numbers) chosen[carrier(samples[i])] = 1;
  DisjointSets sets(carriers);
  const auto join = [&](std::uint32_t a, std::uint32_t b) {
    if (chosen[a] != 0 && chosen[b] != 0) sets.join(a, b);
  };
  for (std::uint32_t edge = 0; edge < edges_.count(); ++edge) {
    const auto sides = edges_.at(edge);
    if (sides.empty()) continue;
    if (at_ == SampleAt::vertices) {
      const auto& vertices = triangles_.records[sides[0].slot].vertices;
      join(vertices[sides[0].side], vertices[(sides[0].side + 1) % 3]);
    } else {
      for (std::size_t i = 1; i < sides.size(); ++i) join(sides[i - 1].slot, sides[i].slot);
    }
  }
  std::vector<std::vector<std::uint32_t>> groups;
  std::unordered_map<std::size_t, std::size_t> group_of;
  for (const std::uint32_t i : numbers) {
    const auto [at, is_new] = group_of.try_emplace(sets.root(carrier(samples[i])), groups.size());
    if (is_new) groups.emplace_back();
    groups[at->second].push_back(i);
  }
  return groups;
}

}  // namespace cdfr
