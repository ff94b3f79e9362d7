#include "parts/mesh_check.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

namespace cdfr::test {
namespace {

using Edges = std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t>;

std::size_t count_twins(const Mesh& mesh) {
  std::vector<std::tuple<double, double, double>> places;
  for (const Vec3& v : mesh.vertices) places.emplace_back(v.x, v.y, v.z);
  std::sort(places.begin(), places.end());
  return static_cast<std::size_t>(places.end() - std::unique(places.begin(), places.end()));
}

std::uint32_t root_of(std::vector<std::uint32_t>& parent, std::uint32_t v) {
  while (parent[v] != v) v = parent[v] = parent[parent[v]];
  return v;
}

std::size_t count_components(const Mesh& mesh) {
  std::vector<std::uint32_t> parent(mesh.vertices.size());
  std::iota(parent.begin(), parent.end(), 0U);
  for (const Triangle& t : mesh.triangles) {
    parent[root_of(parent, t[0])] = root_of(parent, t[1]);
    parent[root_of(parent, t[1])] = root_of(parent, t[2]);
  }
  std::size_t count = 0;
  for (std::uint32_t v = 0; v < parent.size(); ++v) count += root_of(parent, v) == v ? 1U : 0U;
  return count;
}

/// Walks once around each vertex and compares with the number of its triangles.
void check_fans(const Mesh& mesh, const Edges& edges, MeshCheck& check) {
  std::vector<std::size_t> sizes(mesh.vertices.size(), 0);
  std::vector<std::uint32_t> first(mesh.vertices.size(), no_index);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const std::uint32_t v : mesh.triangles[t]) {
      ++sizes[v];
      first[v] = t;
    }
  }
  for (std::uint32_t v = 0; v < sizes.size(); ++v) {
    if (sizes[v] == 0) {
      ++check.unused;
      continue;
    }
    std::size_t walked = 0;
    std::uint32_t at = first[v];
    do {
      const Triangle& t = mesh.triangles[at];
      const std::size_t place = t[0] == v ? 0 : t[1] == v ? 1 : 2;
      const auto next = edges.find({v, t[(place + 2) % 3]});
      if (next == edges.end()) break;
      at = next->second;
      ++walked;
    } while (at != first[v] && walked <= sizes[v]);
    if (walked != sizes[v]) ++check.pinched;
  }
}

double area(Vec3 a, Vec3 b, Vec3 c) {
  const Vec3 u{b.x - a.x, b.y - a.y, b.z - a.z};
  const Vec3 v{c.x - a.x, c.y - a.y, c.z - a.z};
  return std::hypot(u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x) / 2;
}

}  // namespace

MeshCheck check_mesh(const Mesh& mesh) {
  MeshCheck check;
  Edges edges;
  check.box = {mesh.vertices[0], mesh.vertices[0]};
  check.smallest_area = std::numeric_limits<double>::infinity();
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto [i, j, k] = mesh.triangles[t];
    for (const auto& edge : {std::pair{i, j}, std::pair{j, k}, std::pair{k, i}}) {
      if (!edges.emplace(edge, t).second) ++check.repeated_edges;
    }
    const Vec3 a = mesh.vertices[i];
    const Vec3 b = mesh.vertices[j];
    const Vec3 c = mesh.vertices[k];
    check.smallest_area = std::min(check.smallest_area, area(a, b, c));
    check.volume +=
        (a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) + a.z * (b.x * c.y - b.y * c.x)) / 6;
    for (const Vec3& v : {a, b, c}) {
      check.box.lo = {std::min(check.box.lo.x, v.x), std::min(check.box.lo.y, v.y),
                      std::min(check.box.lo.z, v.z)};
      check.box.hi = {std::max(check.box.hi.x, v.x), std::max(check.box.hi.y, v.y),
                      std::max(check.box.hi.z, v.z)};
    }
  }
  for (const auto& [edge, t] : edges) check.lone_edges += edges.contains({edge.second, edge.first}) ? 0U : 1U;
  check_fans(mesh, edges, check);
  check.twins = count_twins(mesh);
  check.components = count_components(mesh);
  return check;
}

}  // namespace cdfr::test
