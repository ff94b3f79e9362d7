/// The mesh's vertices inside faces and cells, and the triangles around them.
///
/// Cubical marching squares (Ho, Wu, Chen, Chuang, Ouhyoung 2005): the curve is drawn on the cells' faces
/// first, sharp where the contour is, then each cell spans a surface into its loop. Here it is a fan from one
/// point strictly inside the cell. A loop lies on the boundary of a convex cell, which every ray from that
/// point meets once, so the fan does not meet itself, and it meets fans of other cells in the pieces on
/// common faces alone. So the mesh is closed, manifold and embedded by construction, in exact arithmetic on
/// the rounded coordinates, for these keep vertices on their edge, face and cell. Dual contouring (Ju et al.
/// 2002) needs the edge and face tests of Ju and Udeshi (2006) for that and has them by polygons that may
/// leave the cells; Schaefer, Ju, Warren (2007) make it manifold, not embedded. Pavic and Kobbelt (2008) find
/// offset surfaces with dual contouring on such an octree and smooth them afterwards.
///
/// A leaf of the deepest level with several loops takes straight pieces on its faces and a fan from the mean
/// of each loop's own points: convex hulls of the loops of one cell are disjoint
/// (tests/contour/mesh_cases_test.cpp tries all signs).
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "cdfr/contour/mesh.h"
#include "contour/cell_apex.h"
#include "contour/conforming.h"

namespace cdfr {

class CellFans {
 public:
  CellFans(const Sought& sought, const SurfaceLeaves& leaves, const Crossings& crossings,
           const Conforming& conforming)
      : sought_(sought), leaves_(leaves), crossings_(crossings), conforming_(conforming) {}

  /// Places all vertices. False if cancelled.
  bool place(Progress& progress);
  /// Leaves larger than the finest whose triangles are farther from the contour than the tolerance, by
  /// centroids.
  const std::vector<std::uint32_t>& loose() const noexcept { return loose_; }
  double largest_error() const noexcept { return largest_error_; }
  std::uint64_t evaluations() const noexcept { return evaluations_; }
  /// More than 2^32 - 2 triangles: two a piece of curve at most in each of its cells.
  bool too_large() const noexcept { return 4 * conforming_.curves().faces().size() >= no_index; }
  Mesh mesh() const;

 private:
  struct Tally {
    std::vector<std::uint32_t> loose;
    SurfaceTally measured;
    std::vector<Vec3> checked;                ///< points of the mesh to be measured
    std::vector<std::uint32_t> checked_leaf;  ///< where they are
    std::vector<WeightedCrossing> crossings;  ///< of the loop at hand
  };

  bool many_loops(std::uint32_t leaf) const noexcept { return conforming_.loops(leaf).size() > 2; }
  PlainCube cube_of(std::uint32_t leaf) const;
  Vec3 apex_of(std::uint32_t leaf, CurveLoop loop, Tally& tally) const;
  void add_checks(std::uint32_t leaf, Tally& tally) const;
  void check(Tally& tally, Progress& progress) const;
  bool place_bends(Progress& progress);
  bool place_apexes(Progress& progress);
  void add(const std::vector<Tally>& tallies);

  const Sought& sought_;
  const SurfaceLeaves& leaves_;
  const Crossings& crossings_;
  const Conforming& conforming_;
  std::vector<std::optional<Vec3>> bends_;  ///< by minimal face
  std::vector<Vec3> apexes_;                ///< by loop
  std::vector<std::uint32_t> first_apex_;   ///< by leaf
  std::vector<std::uint32_t> loose_;
  double largest_error_ = 0;
  std::uint64_t evaluations_ = 0;
};

}  // namespace cdfr
