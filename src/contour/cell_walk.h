/// A walk over an octree's minimal faces and edges, each met once.
///
/// A minimal face is the face of the smaller one of two leaves that touch in it, a minimal edge that of the
/// smallest of the leaves around it. The recursion is that of Ju, Losasso, Schaefer, Warren, "Dual contouring
/// of Hermite data" (2002): cells give the faces and edges between their children, faces those between the
/// children on both sides, edges their halves. Leaves may differ by any number of levels.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "contour/surface_octree.h"

namespace cdfr {

/// Meets only faces and edges all of whose leaves are active, for others have one sign throughout, and one of
/// whose leaves is looked for.
///  - edge(axis, leaves): four cells by u + 2 w, the place of each around the edge, u = axis + 1, w = axis +
///  2 (mod 3);
///    one that the edge passes in the middle of a face comes twice.
///  - face(axis, below, above): the two cells.
///  - sought(cell): may the cell be one that is looked for, or hold one?
template <class Sought, class Edge, class Face>
class CellWalk {
 public:
  CellWalk(const std::vector<SurfaceCell>& cells, Sought sought, Edge edge, Face face)
      : cells_(cells), sought_(sought), edge_(edge), face_(face) {}

  void run() { in_cell(0); }

 private:
  using Four = std::array<std::uint32_t, 4>;

  bool inner(std::uint32_t cell) const { return cells_[cell].state == CellState::inner; }
  bool busy(std::uint32_t cell) const { return cells_[cell].busy; }
  std::uint32_t part(std::uint32_t cell, std::uint32_t child) const {
    return inner(cell) ? cells_[cell].first_child + child : cell;
  }

  void in_cell(std::uint32_t cell) {
    if (!busy(cell) || !inner(cell) || !sought_(cell)) return;
    const std::uint32_t first = cells_[cell].first_child;
    for (std::uint32_t child = 0; child < 8; ++child) in_cell(first + child);
    for (unsigned axis = 0; axis < 3; ++axis) {
      const unsigned along = 1U << axis, u = 1U << (axis + 1) % 3, w = 1U << (axis + 2) % 3;
      for (const unsigned at : {0U, u, w, u | w}) on_face(axis, first + at, first + (at | along));
      for (const unsigned at : {0U, along})
        on_edge(axis, {first + at, first + (at | u), first + (at | w), first + (at | u | w)});
    }
  }

  void on_face(unsigned axis, std::uint32_t below, std::uint32_t above) {
    if (!busy(below) || !busy(above) || !(sought_(below) || sought_(above))) return;
    if (!inner(below) && !inner(above)) {
      face_(axis, below, above);
      return;
    }
    const unsigned b_axis = (axis + 1) % 3, c_axis = (axis + 2) % 3;
    const unsigned a = 1U << axis, b = 1U << b_axis, c = 1U << c_axis;
    for (const unsigned at : {0U, b, c, b | c}) on_face(axis, part(below, at | a), part(above, at));
    for (const unsigned at : {0U, b})
      on_edge(b_axis, {part(below, at | a), part(below, at | a | c), part(above, at), part(above, at | c)});
    for (const unsigned at : {0U, c})
      on_edge(c_axis, {part(below, at | a), part(above, at), part(below, at | a | b), part(above, at | b)});
  }

  void on_edge(unsigned axis, const Four& around) {
    bool divided = false, sought = false;
    for (const std::uint32_t cell : around) {
      if (!busy(cell)) return;
      divided = divided || inner(cell);
      sought = sought || sought_(cell);
    }
    if (!sought) return;
    if (!divided) {
      edge_(axis, around);
      return;
    }
    const unsigned along = 1U << axis, u = 1U << (axis + 1) % 3, w = 1U << (axis + 2) % 3;
    for (const unsigned at : {0U, along}) {
      on_edge(axis, {part(around[0], at | u | w), part(around[1], at | w), part(around[2], at | u),
                     part(around[3], at)});
    }
  }

  const std::vector<SurfaceCell>& cells_;
  Sought sought_;
  Edge edge_;
  Face face_;
};

}  // namespace cdfr
