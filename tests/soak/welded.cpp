#include "soak/welded.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace cdfr::soak {

Mesh welded(const Mesh& mesh) {
  Mesh result;
  std::map<std::array<double, 3>, std::uint32_t> numbers;
  const auto number_of = [&](const Vec3& v) {
    const auto next = static_cast<std::uint32_t>(result.vertices.size());
    const auto [at, is_new] = numbers.try_emplace({v.x, v.y, v.z}, next);
    if (is_new) result.vertices.push_back(v);
    return at->second;
  };
  for (const Triangle& t : mesh.triangles) {
    const Triangle w{number_of(mesh.vertices[t[0]]), number_of(mesh.vertices[t[1]]),
                     number_of(mesh.vertices[t[2]])};
    if (w[0] != w[1] && w[1] != w[2] && w[2] != w[0]) result.triangles.push_back(w);
  }
  return result;
}

std::optional<DirectedEdges> closed_edges(const std::vector<Triangle>& triangles) {
  DirectedEdges edges;
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (!edges.try_emplace({triangles[t][k], triangles[t][(k + 1) % 3]}, t).second) return std::nullopt;
    }
  }
  for (const auto& [edge, t] : edges) {
    if (!edges.contains({edge.second, edge.first})) return std::nullopt;
  }
  return edges;
}

double largest_coordinate(const Mesh& mesh) noexcept {
  double largest = 0;
  for (const Vec3& v : mesh.vertices)
    largest = std::max({largest, std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
  return largest;
}

}  // namespace cdfr::soak
