#include "analysis/smooth_regions.h"

#include <algorithm>
#include <cstddef>

#include "analysis/sample_neighbours.h"
#include "core/arithmetic.h"
#include "geometry/orientation.h"
#include "mesh/disjoint_sets.h"

namespace cdfr {
namespace {

constexpr double degrees_a_radian = 57.295779513082321;

/// At an edge that more triangles share than solids have there, no two of them are told to adjoin.
constexpr std::size_t most_sides = 16;

std::uint32_t start_of(const TriangleStore& triangles, TriangleSide s) noexcept {
  return triangles.records[s.slot].vertices[s.side];
}

bool is_smooth(const TriangleStore& triangles, std::span<const TriangleSide> sides, double sharp) noexcept {
  return sides.size() == 2 && turn_in_degrees(triangles, sides[0], sides[1]) <= sharp;
}

bool bends(const TriangleStore& triangles, TriangleSide a, TriangleSide b, Bend bend) noexcept {
  if (start_of(triangles, a) == start_of(triangles, b)) return false;
  const auto& t = triangles.shape(a.slot).vertices;
  const int above = orientation(t[0], t[1], t[2], triangles.shape(b.slot).vertices[(b.side + 2) % 3]);
  return bend == Bend::convex ? above < 0 : above > 0;
}

}  // namespace

double turn_in_degrees(const TriangleStore& triangles, TriangleSide a, TriangleSide b) noexcept {
  const Vec3 n = rounded(triangles.shape(a.slot).normal), m = rounded(triangles.shape(b.slot).normal);
  if (n == Vec3{} || m == Vec3{} || start_of(triangles, a) == start_of(triangles, b)) return 180;
  return angle_between(n, m) * degrees_a_radian;
}

SmoothRegions::SmoothRegions(const TriangleStore& triangles, const TriangleEdges& edges, double sharp,
                             Bend bend) {
  at_edge_.assign(vertex_count(triangles), 0);
  join(triangles, edges, sharp);
  for (std::uint32_t edge = 0; edge < edges.count(); ++edge) {
    const auto sides = edges.at(edge);
    if (sides.size() >= 2 && sides.size() <= most_sides && !is_smooth(triangles, sides, sharp))
      note_design_edge(triangles, sides, bend);
  }
  std::sort(adjoining_.begin(), adjoining_.end());
  adjoining_.erase(std::unique(adjoining_.begin(), adjoining_.end()), adjoining_.end());
}

void SmoothRegions::join(const TriangleStore& triangles, const TriangleEdges& edges, double sharp) {
  DisjointSets sets(triangles.size());
  for (std::uint32_t edge = 0; edge < edges.count(); ++edge) {
    const auto sides = edges.at(edge);
    if (is_smooth(triangles, sides, sharp)) sets.join(sides[0].slot, sides[1].slot);
  }
  regions_.resize(triangles.size());
  for (std::uint32_t slot = 0; slot < triangles.size(); ++slot) {
    const std::size_t root = sets.root(slot);
    regions_[slot] = root == slot ? count_++ : regions_[root];
  }
}

void SmoothRegions::note_design_edge(const TriangleStore& triangles, std::span<const TriangleSide> sides,
                                     Bend bend) {
  for (std::size_t i = 0; i < sides.size(); ++i) {
    for (std::size_t j = i + 1; j < sides.size(); ++j) {
      if (!bends(triangles, sides[i], sides[j], bend)) continue;
      const auto [a, b] = std::minmax(regions_[sides[i].slot], regions_[sides[j].slot]);
      if (a != b) adjoining_.emplace_back(a, b);
      const auto& vertices = triangles.records[sides[i].slot].vertices;
      at_edge_[vertices[sides[i].side]] = at_edge_[vertices[(sides[i].side + 1) % 3]] = 1;
    }
  }
}

bool SmoothRegions::adjoin(std::uint32_t a, std::uint32_t b) const noexcept {
  return std::binary_search(adjoining_.begin(), adjoining_.end(),
                            std::pair<std::uint32_t, std::uint32_t>(std::minmax(a, b)));
}

}  // namespace cdfr
