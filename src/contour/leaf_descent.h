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
/// may be moved; beyond the region the field is asked. What this cannot settle goes the general way
/// (Descent::finish): cubes that the surface may enter, points moved across the medial axis, triangles of no
/// area.
///
/// Rounding: geometry/feet.h. Points are within that of the contour, those moved away within twice that.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
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
  LeafDescent(const FieldData& field, const Level& level, Descent& single, std::vector<ContourPoint>& points);

  /// False, and nothing done, if the region's list is none that this takes: it has BVH nodes, or very many
  /// triangles. Precondition: the region passes.
  bool run(const Region& region);
  const DescentCounts& counts() const noexcept { return counts_; }
  void clear_counts() noexcept { counts_ = {}; }

 private:
  /// What is known of a cube: is all of it on the contour's side?
  enum class Sided { open, right, wrong };
  /// A cube of final size and the place of its point, if it has one.
  struct Placed {
    Vec3 centre;
    std::size_t point;
    bool is_there;
    bool is_excluded = false;  ///< the contour is not in the cube
  };

  struct Moved {
    ContourPoint point;
    double by;
    Vec3 beyond;  ///< a hair farther, from the middle
  };

  Sided side_in(const Region& region) const noexcept;
  void descend(const Cube& cube, FrameNumbers numbers, Sided sided);
  void tile(const Cube& cube, FrameNumbers numbers);
  void halve(double size);
  void keep_passing(double size, FrameNumbers numbers);
  void finish(std::size_t first, FrameNumbers numbers);
  double error_of(double move) const noexcept;
  std::optional<Moved> moved(std::size_t i, const Vec3& from);
  bool in_region(const Vec3& x) const noexcept;
  void put(std::size_t i, const Vec3& centre, FrameNumbers numbers);
  bool put_again(std::size_t i, const Placed& placed);
  void check_moved(FrameNumbers numbers);
  bool is_below(const Vec3& centre, FrameNumbers numbers);
  void check_beyond_region();
  void redo_failed();
  Sided side_of(const Cube& cube, double distance) noexcept;
  void make_frames(FrameNumbers numbers);
  std::uint32_t base_triangle(std::size_t number, TrianglePlace place);
  std::uint32_t lowest_at(std::size_t number, TrianglePlace place) const noexcept;
  FrameNumbers pruned(const Cube& cube, FrameNumbers numbers, std::uint16_t* kept) const noexcept;
  Vec3 from_middle(const Vec3& x) const noexcept {
    return {x.x - middle_.x, x.y - middle_.y, x.z - middle_.z};
  }

  const FieldData& field_;
  const Level& level_;
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
  std::vector<Placed> beyond_;                      ///< moved out of the region
  std::vector<Placed> failed_;                      ///< left to the general way
  std::vector<ContourPoint> before_;                ///< the points while those are redone

  // Of the tile, from the middle.
  RegionPoints centres_, octants_;
  alignas(64) std::array<double, RegionPoints::most> squared_;
  Feet feet_;
  RegionPoints moved_, again_;  ///< a hair beyond the points of
  std::vector<Placed> moved_from_, again_from_;
};

}  // namespace cdfr
