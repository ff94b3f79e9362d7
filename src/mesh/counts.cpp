#include "mesh/counts.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/offset.h"
#include "geometry/unit_normal.h"
#include "mesh/disjoint_sets.h"

namespace cdfr {
namespace {

/// The uses of an edge by triangles that are not collapsed, into `uses`.
void live_uses(const Topology& topology, std::uint32_t edge, Large<Topology::Use>& uses) {
  uses.clear();
  for (const auto& use : topology.uses_of(edge)) {
    if (!topology.collapsed(use.triangle)) uses.push_back(use);
  }
}

/// Counts edges by their uses, and joins in `triangles` and `fans` (corners) what shares an edge.
void audit_edges(const Topology& topology, DisjointSets& triangles, DisjointSets& fans, MeshReport& report,
                 const Scratch* scratch) {
  Large<Topology::Use> uses(scratch);
  for (std::uint32_t e = 0; e < topology.edges.size(); ++e) {
    live_uses(topology, e, uses);
    int balance = 0;
    for (const Topology::Use& use : uses) balance += use.forward ? 1 : -1;
    if (balance != 0) ++report.unbalanced_edges;
    if (uses.size() == 1) ++report.open_edges;
    if (uses.size() > 2) ++report.nonmanifold_edges;
    if (uses.size() == 2 && uses[0].forward == uses[1].forward) ++report.flipped_edges;
    for (std::size_t i = 1; i < uses.size(); ++i) {
      triangles.join(uses[0].triangle, uses[i].triangle);
      for (const std::uint32_t vertex : topology.edges[e].vertices) {
        fans.join(topology.corner_of(uses[0].triangle, vertex), topology.corner_of(uses[i].triangle, vertex));
      }
    }
  }
}

void count_components(const Topology& topology, DisjointSets& triangles, MeshReport& report) {
  for (std::size_t t = 0; t < topology.triangles.size(); ++t) {
    if (!topology.collapsed(t) && triangles.root(t) == t) ++report.components;
  }
}

void count_nonmanifold_vertices(const Topology& topology, DisjointSets& fans, MeshReport& report,
                                const Scratch* scratch) {
  Large<std::uint8_t> fans_at(topology.vertex_count, 0, scratch);
  for (std::size_t corner = 0; corner < 3 * topology.triangles.size(); ++corner) {
    const Triangle& triangle = topology.triangles[corner / 3];
    if (topology.collapsed(corner / 3) || fans.root(corner) != corner) continue;
    std::uint8_t& count = fans_at[triangle[corner % 3]];
    if (count == 1) ++report.nonmanifold_vertices;
    if (count < 2) ++count;
  }
}

Vec3 cross(const Vec3& a, const Vec3& b) noexcept {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
double dot(const Vec3& a, const Vec3& b) noexcept { return a.x * b.x + a.y * b.y + a.z * b.z; }

/// A sum that carries what rounding drops from it (Neumaier), so that a million terms cost no digits.
class CompensatedSum {
 public:
  void add(double term) noexcept {
    const double next = sum_ + term;
    dropped_ += std::fabs(sum_) >= std::fabs(term) ? (sum_ - next) + term : (term - next) + sum_;
    sum_ = next;
  }
  double value() const noexcept { return sum_ + dropped_; }

 private:
  double sum_ = 0;
  double dropped_ = 0;
};

/// Corners are taken from the centre of the box: far from the origin, products of the coordinates themselves
/// would cancel all digits of the volume. Where the surface has a boundary, the volume is that of its cone
/// from there.
void measure(const MeshView& mesh, MeshReport& report) {
  const Vec3 lo = report.box.lo, hi = report.box.hi;
  const Vec3 centre{lo.x + (hi.x - lo.x) / 2, lo.y + (hi.y - lo.y) / 2, lo.z + (hi.z - lo.z) / 2};
  CompensatedSum volume, area;
  for (const Triangle& triangle : mesh.triangles) {
    const Vec3 a = mesh.vertices[triangle[0]], b = mesh.vertices[triangle[1]], c = mesh.vertices[triangle[2]];
    const Vec3 normal = cross(minus(b, a), minus(c, a));
    if (collinear(a, b, c)) {
      ++report.degenerate_triangles;
      continue;
    }
    area.add(std::sqrt(dot(normal, normal)) / 2);
    volume.add(dot(minus(a, centre), normal) / 6);
  }
  report.area = area.value();
  report.volume = volume.value();
}

}  // namespace

Box box_of(const MeshView& mesh) noexcept {
  const double inf = std::numeric_limits<double>::infinity();
  Box box{{inf, inf, inf}, {-inf, -inf, -inf}};
  for (const Triangle& triangle : mesh.triangles) {
    for (const std::uint32_t corner : triangle) {
      const Vec3 p = mesh.vertices[corner];
      box.lo = {std::min(box.lo.x, p.x), std::min(box.lo.y, p.y), std::min(box.lo.z, p.z)};
      box.hi = {std::max(box.hi.x, p.x), std::max(box.hi.y, p.y), std::max(box.hi.z, p.z)};
    }
  }
  return box;
}

MeshReport counted(MeshView mesh, const Topology& topology, std::span<const std::uint32_t> first_twins,
                   const Scratch* scratch) {
  MeshReport report;
  report.triangles = mesh.triangles.size();
  report.vertices = topology.vertex_count;
  DisjointSets triangles(topology.triangles.size(), scratch), fans(3 * topology.triangles.size(), scratch);
  audit_edges(topology, triangles, fans, report, scratch);
  count_components(topology, triangles, report);
  count_nonmanifold_vertices(topology, fans, report, scratch);
  for (std::uint32_t t = 0; t < first_twins.size(); ++t) report.duplicate_triangles += first_twins[t] != t;
  report.box = box_of(mesh);
  measure(mesh, report);
  return report;
}

}  // namespace cdfr
