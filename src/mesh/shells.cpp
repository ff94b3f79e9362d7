#include "mesh/shells.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "core/parallel.h"
#include "mesh/crossings.h"
#include "mesh/disjoint_sets.h"

namespace cdfr {
namespace {

/// By slot: 1 if the triangle has an area of its own that no other one meets but at shared edges and corners.
std::vector<std::uint8_t> clean_triangles(const Examined& mesh, const std::vector<std::uint8_t>& touching) {
  const TriangleStore& store = mesh.triangles;
  std::vector<std::uint8_t> clean(store.size());
  const auto corners = [&](std::uint32_t slot) {
    std::array<std::uint32_t, 3> ids = store.records[slot].vertices;
    std::sort(ids.begin(), ids.end());
    return ids;
  };
  std::vector<std::uint32_t> order(store.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return corners(a) < corners(b); });
  for (std::size_t i = 0; i < order.size(); ++i) {
    const std::uint32_t slot = order[i];
    const bool doubled = (i > 0 && corners(order[i - 1]) == corners(slot)) ||
                         (i + 1 < order.size() && corners(order[i + 1]) == corners(slot));
    const bool flat = rounded(store.shape(slot).normal) == Vec3{};
    clean[slot] = !doubled && !flat && !touching[slot];
  }
  return clean;
}

/// An edge is plain if just two triangles use it, in opposite directions, and both are clean.
void find_plain_edges(Examined& mesh, const std::vector<std::uint8_t>& clean_number, DisjointSets& shells) {
  const Topology& topology = mesh.topology;
  mesh.plain_edges.assign(topology.edges.size(), 0);
  for (std::uint32_t e = 0; e < topology.edges.size(); ++e) {
    const auto uses = topology.uses_of(e);
    if (uses.size() != 2 || uses[0].forward == uses[1].forward) continue;
    if (!clean_number[uses[0].triangle] || !clean_number[uses[1].triangle]) continue;
    mesh.plain_edges[e] = 1;
    shells.join(uses[0].triangle, uses[1].triangle);
  }
}

/// A vertex is plain if its triangles form one fan with plain edges all round.
void find_plain_vertices(Examined& mesh) {
  const Topology& topology = mesh.topology;
  DisjointSets fans(3 * topology.triangles.size());
  const auto corner = [&](std::uint32_t triangle, std::uint32_t vertex) {
    const Triangle& t = topology.triangles[triangle];
    return 3 * std::size_t{triangle} + (t[0] == vertex ? 0U : t[1] == vertex ? 1U : 2U);
  };
  mesh.plain_vertices.assign(topology.vertex_count, 1);
  for (std::uint32_t e = 0; e < topology.edges.size(); ++e) {
    const auto uses = topology.uses_of(e);
    for (const std::uint32_t vertex : topology.edges[e].vertices) {
      if (mesh.plain_edges[e] == 0) {
        mesh.plain_vertices[vertex] = 0;
      } else {
        fans.join(corner(uses[0].triangle, vertex), corner(uses[1].triangle, vertex));
      }
    }
  }
  std::vector<std::uint8_t> met(topology.vertex_count, 0);
  for (std::size_t c = 0; c < 3 * topology.triangles.size(); ++c) {
    if (fans.root(c) != c) continue;
    const std::uint32_t vertex = topology.triangles[c / 3][c % 3];
    if (met[vertex] != 0) mesh.plain_vertices[vertex] = 0;
    met[vertex] = 1;
  }
}

Sides sides_of(int winding_in_front) noexcept {
  if (winding_in_front == 0) return Sides::outward;
  return winding_in_front > 0 ? Sides::both_inside : Sides::both_outside;
}

}  // namespace

void find_shells(Examined& mesh, const std::vector<std::uint8_t>& touching) {
  const std::vector<std::uint8_t> clean = clean_triangles(mesh, touching);
  std::vector<std::uint32_t> slot_of(clean.size());
  std::vector<std::uint8_t> clean_number(clean.size());
  for (std::uint32_t slot = 0; slot < clean.size(); ++slot) {
    slot_of[mesh.triangles.records[slot].number] = slot;
    clean_number[mesh.triangles.records[slot].number] = clean[slot];
  }
  DisjointSets shells(clean.size());
  find_plain_edges(mesh, clean_number, shells);
  find_plain_vertices(mesh);
  if (!mesh.report.balanced()) return;
  std::vector<std::uint32_t> roots;
  for (std::uint32_t number = 0; number < clean.size(); ++number) {
    if (clean_number[number] != 0 && shells.root(number) == number) roots.push_back(slot_of[number]);
  }
  std::vector<int> winding(roots.size());
  for_chunks(roots.size(), 1,
             [&](std::size_t i, std::size_t) { winding[i] = winding_in_front(roots[i], mesh.space()); });
  for (std::size_t i = 0; i < roots.size(); ++i) {
    mesh.triangles.records[roots[i]].sides = sides_of(winding[i]);
    mesh.report.turned_shells += winding[i] != 0;
  }
  for (std::uint32_t number = 0; number < clean.size(); ++number) {
    if (clean_number[number] == 0) continue;
    mesh.triangles.records[slot_of[number]].sides =
        mesh.triangles.records[slot_of[shells.root(number)]].sides;
  }
}

}  // namespace cdfr
