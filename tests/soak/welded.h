/// A mesh as the checks and the points see it: vertices of equal coordinates are one, collapsed triangles are
/// gone, and what is left is closed.
#pragma once

#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "cdfr/mesh/mesh.h"

namespace cdfr::soak {

/// From an edge as a triangle runs along it, tail to head, to that triangle.
class DirectedEdges {
 public:
  explicit DirectedEdges(std::size_t count) { triangles_.reserve(count); }
  /// False if there is one already.
  bool add(std::uint32_t tail, std::uint32_t head, std::uint32_t triangle) {
    return triangles_.try_emplace(key(tail, head), triangle).second;
  }
  void remove(std::uint32_t tail, std::uint32_t head) { triangles_.erase(key(tail, head)); }
  bool has(std::uint32_t tail, std::uint32_t head) const { return triangles_.contains(key(tail, head)); }
  /// Precondition: has(tail, head).
  std::uint32_t at(std::uint32_t tail, std::uint32_t head) const { return triangles_.at(key(tail, head)); }

 private:
  static std::uint64_t key(std::uint32_t tail, std::uint32_t head) {
    return std::uint64_t{tail} << 32 | head;
  }
  std::unordered_map<std::uint64_t, std::uint32_t> triangles_;
};

/// Keeps the order of what it keeps. Patches are dropped.
Mesh welded(const Mesh& mesh);

/// None if a directed edge is used twice or one way only: not closed, not oriented or not a manifold.
std::optional<DirectedEdges> closed_edges(const std::vector<Triangle>& triangles);

/// Largest absolute coordinate.
double largest_coordinate(const Mesh& mesh) noexcept;

}  // namespace cdfr::soak
