/// Leaves refined until the mesh's pieces in neighbouring cells fit together.
///
/// What is asked of a leaf above the deepest level: the contour crosses each of its twelve sides at most
/// once, each minimal face on it is passed by one piece of curve at most, and the pieces close to one loop.
/// At the deepest level a side is a minimal edge and a face a minimal face, so that only faces with four
/// crossings and cells with several loops remain (cell_faces.h). A leaf that fails is split, which ends at
/// the deepest level.
#pragma once

#include <vector>

#include "contour/cell_curves.h"
#include "contour/crossings.h"
#include "contour/surface_leaves.h"

namespace cdfr {

class Conforming {
 public:
  Conforming(SurfaceLeaves& leaves, Crossings& crossings)
      : leaves_(leaves), crossings_(crossings), curves_(leaves) {}

  /// False if cancelled or if the octree has overflowed.
  bool run(Progress& progress);
  const CellCurves& curves() const noexcept { return curves_; }
  /// Where a leaf's loops begin, and where the last one ends, in its pieces.
  std::span<const std::uint32_t> loops(std::uint32_t leaf) const noexcept {
    return std::span(starts_).subspan(first_start_[leaf], first_start_[leaf + 1] - first_start_[leaf]);
  }

 private:
  /// Over the faces and edges of leaves that no walk has met: what is between others stays as it is.
  void walk();
  void cross(unsigned axis, const std::array<std::uint32_t, 4>& around);
  void set_side(std::uint32_t leaf, int side, std::uint32_t crossing);
  void check_face(const MinimalFace& face);
  void mark(std::uint32_t leaf);
  bool split_marked(Progress& progress);
  bool close_loops(Progress& progress);

  SurfaceLeaves& leaves_;
  Crossings& crossings_;
  CellCurves curves_;
  std::vector<MinimalFace> faces_;       ///< also of leaves that were split since they were met
  std::vector<unsigned char> marked_;    ///< by leaf
  std::vector<std::uint32_t> to_split_;  ///< those that are
  std::vector<std::uint32_t> seen_;      ///< by cell: the walk whose new leaves it is above
  std::uint32_t walks_ = 0;
  std::size_t walked_ = 0;  ///< leaves that were met
  std::vector<std::uint32_t> first_start_, starts_;
};

}  // namespace cdfr
