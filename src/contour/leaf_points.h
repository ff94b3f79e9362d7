/// The points of cubes of final size, moved from the cubes' centres to the contour, of one region of a leaf
/// after another.
///
/// A point moved away from its foot is tested a hair beyond: no triangle of the list may be closer there than
/// the height. The leaf's list is complete for its own points, and kept so for cubes grown by what a point
/// may be moved; beyond the region the field is asked. What this cannot settle goes the general way
/// (Descent::finish): points moved across the medial axis, triangles of no area.
///
/// Rounding: geometry/feet.h. Points are within that of the contour, those moved away within twice that.
#pragma once

#include <optional>
#include <vector>

#include "contour/descent.h"
#include "contour/leaf_triangles.h"

namespace cdfr {

/// Where points are looked for.
struct LeafRegion {
  Cube cube;
  Vec3 middle;
  double final_size = 0;
  double error = 0;  ///< of distances and points: TriangleFrame::error, and what a coordinate rounds by
};

class LeafPoints {
 public:
  /// A point is moved by half a diagonal at most, sqrt(3)/2 s from the centre of a cube that reaches s/2: so
  /// many s beyond it.
  static constexpr double grown_by = 0.4;

  /// Points are appended to `points`, as `single` appends its own.
  LeafPoints(const FieldData& field, const Level& level, LeafTriangles& triangles, Descent& single,
             std::vector<ContourPoint>& points)
      : field_(field), level_(level), triangles_(triangles), single_(single), points_(points) {}

  void begin(const LeafRegion& region) { region_ = region; }
  /// Those of the cubes about these centres that pass, at most Feet::most. Precondition: `near` has what may
  /// be closest in the cubes, grown.
  void put(const RegionPoints& centres, const NearTriangles& near);
  /// Of the region.
  void end();
  const DescentCounts& counts() const noexcept { return counts_; }
  void clear_counts() noexcept { counts_ = {}; }

 private:
  /// A cube and the place of its point, if it has one.
  struct Placed {
    Vec3 centre;
    std::size_t point;
    bool is_there;
    bool is_excluded = false;  ///< the contour is not in the cube
  };

  bool has_way(std::size_t i) const noexcept;
  Vec3 moved_by(double length, std::size_t i, const Vec3& from) const noexcept;
  void set_point(ContourPoint& point, std::size_t i, const Vec3& from, double move);
  double error_of(double move) const noexcept;
  bool in_region(const Vec3& x) const noexcept;
  void put_one(std::size_t i, const Vec3& centre, double move, bool is_alone);
  bool put_again(std::size_t i, const Placed& placed);
  void check_moved(const NearTriangles& near);
  bool is_below(const Vec3& centre, const NearTriangles& near);
  void redo_failed();

  const FieldData& field_;
  const Level& level_;
  LeafTriangles& triangles_;
  Descent& single_;
  std::vector<ContourPoint>& points_;
  DescentCounts counts_;

  LeafRegion region_;
  std::vector<Placed> beyond_;        ///< moved out of the region
  std::vector<Placed> failed_;        ///< left to the general way
  std::vector<ContourPoint> before_;  ///< the points from the first of those on, while they are redone

  // Of the cubes, from the middle.
  Feet feet_;
  RegionPoints moved_, again_;  ///< a hair beyond the points of
  std::vector<Placed> moved_from_, again_from_;
  RegionPoints corners_;
  alignas(64) std::array<double, RegionPoints::most> squared_;
};

}  // namespace cdfr
