/// The descent of descent.h inside a leaf, with many cubes at a time and lists that shrink on the way.
///
/// A cube's list is the leaf's, less the triangles that a closer one dominates over the whole cube (prune in
/// octree/tile_scan.h), so that eight octants and their octants meet few triangles each, in lanes
/// (geometry/feet.h). The rule is the same: a cube passes if |d(c) - height| <= sqrt(3)/2 s, and each one of
/// final size that passes gives one point. It holds for a cube whenever it holds for an octant of it, so no
/// pruning on the way changes which final cubes pass.
///
/// A point moved away from its foot is tested a hair beyond: no triangle of the list may be closer there than
/// the height. The list is complete for the points of the leaf, and kept so for cubes grown by what a point
/// may be moved. What this cannot settle goes the general way (Descent::finish): cubes that the surface may
/// enter, points moved across the medial axis or out of the region, triangles of no area.
///
/// Rounding: geometry/feet.h. Points are within that of the contour, those moved away within twice that.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "contour/descent.h"
#include "contour/regions.h"
#include "geometry/feet.h"
#include "octree/tile_scan.h"

namespace cdfr {

class LeafDescent {
 public:
  /// Points are appended to `points`, as `single` appends its own.
  LeafDescent(const FieldData& field, const Level& level, double tolerance, Descent& single,
              std::vector<ContourPoint>& points);

  /// False, and nothing done, if the region's list is none that this takes: it has BVH nodes, or very many
  /// triangles. Precondition: the region passes.
  bool run(const Region& region);
  const DescentCounts& counts() const noexcept { return counts_; }
  void clear_counts() noexcept { counts_ = {}; }

 private:
  /// What is known of a cube: is all of it on the contour's side?
  enum class Sided { open, right, wrong };
  /// What a cube of final size comes to.
  enum class Outcome : std::uint8_t { none, point, moved_away, single };

  void descend(const Cube& cube, TileNumbers numbers, Sided sided);
  void tile(const Cube& cube, TileNumbers numbers);
  void keep_passing(TileNumbers numbers);
  void finish(std::span<const Cube> cubes, TileNumbers numbers);
  Outcome outcome(const Cube& cube, std::size_t i, ContourPoint& point);
  void check_moved(TileNumbers numbers, std::size_t count);
  Sided side_of(const Cube& cube, double distance) noexcept;
  void make_frames(TileNumbers numbers);
  std::uint32_t base_triangle(std::size_t number, TrianglePlace place);
  std::uint32_t lowest_at(std::size_t number, TrianglePlace place) const noexcept;
  TileNumbers pruned(const Cube& cube, TileNumbers numbers, std::uint16_t* kept) const noexcept;
  void add_centre(const Cube& cube, RegionPoints& points) const noexcept;
  bool may_enter(double distance, const Cube& cube) const noexcept;

  const FieldData& field_;
  const Level& level_;
  double tolerance_;
  Descent& single_;
  std::vector<ContourPoint>& points_;
  DescentCounts counts_;

  // Of the region.
  TileList list_;
  Cube region_;
  Vec3 middle_;
  double radius_ = 0;
  double final_size_ = 0;
  double error_ = 0;  ///< of distances and points: TriangleFrame::error, and what a coordinate rounds by
  std::vector<TriangleFrame> frames_;  ///< by number, as far as asked for
  std::vector<bool> framed_;
  std::vector<std::array<std::uint32_t, 7>> base_;  ///< by number and place, as far as asked for

  // Of the tile.
  std::vector<Cube> cubes_, octants_;
  Feet feet_;
  std::array<Outcome, RegionPoints::most> outcomes_{};
  std::array<ContourPoint, RegionPoints::most> found_;
};

}  // namespace cdfr
