#include "mesh/shells.h"

#include "core/parallel.h"
#include "mesh/crossings.h"
#include "mesh/disjoint_sets.h"

namespace cdfr {
namespace {

/// By triangle number: 1 if it has an area of its own that no other one meets but at shared edges and
/// corners.
Large<std::uint8_t> clean_triangles(const Examined& mesh, std::span<const std::uint32_t> first_twins,
                                    std::span<const std::uint8_t> touching, const Scratch* scratch) {
  Large<std::uint8_t> clean(first_twins.size(), scratch);
  for (std::uint32_t slot = 0; slot < clean.size(); ++slot) {
    const bool flat = rounded(mesh.triangles.shape(slot).normal) == Vec3{};
    clean[mesh.triangles.records[slot].number] = !flat && !touching[slot];
  }
  for (std::uint32_t t = 0; t < clean.size(); ++t) {
    if (first_twins[t] != t) clean[t] = clean[first_twins[t]] = 0;
  }
  return clean;
}

/// An edge is plain if just two triangles use it, in opposite directions, and both are clean.
void find_plain_edges(Examined& mesh, std::span<const std::uint8_t> clean, DisjointSets& shells) {
  const Topology& topology = mesh.topology;
  mesh.plain_edges.assign(topology.edges.size(), 0);
  for (std::uint32_t e = 0; e < topology.edges.size(); ++e) {
    const auto uses = topology.uses_of(e);
    if (uses.size() != 2 || uses[0].forward == uses[1].forward) continue;
    if (!clean[uses[0].triangle] || !clean[uses[1].triangle]) continue;
    mesh.plain_edges[e] = 1;
    shells.join(uses[0].triangle, uses[1].triangle);
  }
}

/// A vertex is plain if its triangles form one fan with plain edges all round.
void find_plain_vertices(Examined& mesh, const Scratch* scratch) {
  const Topology& topology = mesh.topology;
  DisjointSets fans(3 * topology.triangles.size(), scratch);
  mesh.plain_vertices.assign(topology.vertex_count, 1);
  for (std::uint32_t e = 0; e < topology.edges.size(); ++e) {
    const auto uses = topology.uses_of(e);
    for (const std::uint32_t vertex : topology.edges[e].vertices) {
      if (mesh.plain_edges[e] == 0) {
        mesh.plain_vertices[vertex] = 0;
      } else {
        fans.join(topology.corner_of(uses[0].triangle, vertex), topology.corner_of(uses[1].triangle, vertex));
      }
    }
  }
  Large<std::uint8_t> met(topology.vertex_count, 0, scratch);
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

void find_shells(Examined& mesh, std::span<const std::uint32_t> first_twins,
                 std::span<const std::uint8_t> touching, const Scratch* scratch) {
  const Large<std::uint8_t> clean = clean_triangles(mesh, first_twins, touching, scratch);
  Large<std::uint32_t> slot_of(clean.size(), scratch);
  for (std::uint32_t slot = 0; slot < clean.size(); ++slot)
    slot_of[mesh.triangles.records[slot].number] = slot;
  DisjointSets shells(clean.size(), scratch);
  find_plain_edges(mesh, clean, shells);
  find_plain_vertices(mesh, scratch);
  if (!mesh.report.balanced()) return;
  Large<std::uint32_t> roots(scratch);
  for (std::uint32_t number = 0; number < clean.size(); ++number) {
    if (clean[number] != 0 && shells.root(number) == number) roots.push_back(slot_of[number]);
  }
  Large<int> winding(roots.size(), scratch);
  for_chunks(roots.size(), 1,
             [&](std::size_t i, std::size_t) { winding[i] = winding_in_front(roots[i], mesh.space()); });
  const std::span<TriangleRecord> records = mesh.triangles.records.edit();
  for (std::size_t i = 0; i < roots.size(); ++i) {
    records[roots[i]].sides = sides_of(winding[i]);
    mesh.report.turned_shells += winding[i] != 0;
  }
  for (std::uint32_t number = 0; number < clean.size(); ++number) {
    if (clean[number] == 0) continue;
    records[slot_of[number]].sides = records[slot_of[shells.root(number)]].sides;
  }
}

}  // namespace cdfr
