#include "soak/welded.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace cdfr::soak {

namespace {

/// For each vertex the first one at the same place.
std::vector<std::uint32_t> first_equal(const std::vector<Vec3>& vertices) {
  std::vector<std::uint32_t> order(vertices.size()), first(vertices.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto place = [&](std::uint32_t i) {
    return std::tie(vertices[i].x, vertices[i].y, vertices[i].z);  // -0 equals 0 here
  };
  std::ranges::sort(order, [&](std::uint32_t a, std::uint32_t b) {
    return place(a) != place(b) ? place(a) < place(b) : a < b;
  });
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool same = i > 0 && place(order[i]) == place(order[i - 1]);
    first[order[i]] = same ? first[order[i - 1]] : order[i];
  }
  return first;
}

}  // namespace

Mesh welded(const Mesh& mesh) {
  Mesh result;
  const std::vector<std::uint32_t> first = first_equal(mesh.vertices);
  std::vector<std::uint32_t> numbers(mesh.vertices.size(), no_index);
  const auto number_of = [&](std::uint32_t vertex) {
    std::uint32_t& number = numbers[first[vertex]];
    if (number == no_index) {
      number = static_cast<std::uint32_t>(result.vertices.size());
      result.vertices.push_back(mesh.vertices[first[vertex]]);
    }
    return number;
  };
  for (const Triangle& t : mesh.triangles) {
    const Triangle w{number_of(t[0]), number_of(t[1]), number_of(t[2])};
    if (w[0] != w[1] && w[1] != w[2] && w[2] != w[0]) result.triangles.push_back(w);
  }
  return result;
}

std::optional<DirectedEdges> closed_edges(const std::vector<Triangle>& triangles) {
  DirectedEdges edges(3 * triangles.size());
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (!edges.add(triangles[t][k], triangles[t][(k + 1) % 3], t)) return std::nullopt;
    }
  }
  for (const Triangle& t : triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (!edges.has(t[(k + 1) % 3], t[k])) return std::nullopt;
    }
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
