/// The descent of descent.h inside a leaf, with lists that shrink on the way, so that few triangles are met
/// by many cubes at a time.
///
/// The rule is the same: a cube passes if |d(c) - height| <= sqrt(3)/2 s, and each one of final size that
/// passes gives one point. It holds for a cube whenever it holds for an octant of it, so no pruning on the
/// way changes which final cubes pass. An octant's list is the cube's, less the triangles that a closer one
/// keeps farther all over it (geometry/supports.h). Small cubes on the contour's side are not halved: their
/// triangles' supports bound the distance at the centres of final cubes from both sides, so closely that
/// nearly all that are then measured pass (LeafPoints).
///
/// What this cannot settle goes the general way (Descent::finish): cubes that the surface may enter.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "contour/descent.h"
#include "contour/leaf_points.h"
#include "contour/leaf_triangles.h"
#include "contour/regions.h"
#include "geometry/supports.h"

namespace cdfr {

class LeafDescent {
 public:
  /// Points are appended to `points`, as `single` appends its own.
  LeafDescent(const FieldData& field, const Level& level, Descent& single, std::vector<ContourPoint>& points)
      : field_(field),
        level_(level),
        single_(single),
        triangles_(field),
        finished_(field, level, triangles_, single, points) {}

  /// False, and nothing done, if the region's list is none that this takes: it has BVH nodes, or very many
  /// triangles. Precondition: the region passes.
  bool run(const Region& region);
  DescentCounts counts() const noexcept {
    DescentCounts all = counts_;
    all.add(finished_.counts());
    return all;
  }
  void clear_counts() noexcept {
    counts_ = {};
    finished_.clear_counts();
  }

 private:
  /// What is known of a cube: is all of it on the contour's side?
  enum class Sided { open, right, wrong };
  /// The triangles that may be closest in a cube, the one closest to its centre first, and their supports.
  struct List {
    std::array<std::uint16_t, LeafTriangles::most> numbers;
    std::array<TriangleFrame::Axis, LeafTriangles::most> supports;
    std::size_t count = 0;
    double distance = 0;  ///< of the first, from the centre
    bool has_supports = false;
  };
  /// A cube's octants and its list, or the region alone with all of the leaf's.
  struct Siblings {
    std::array<Cube, 8> cubes;
    std::size_t count = 0;
    List list;
    Supports supports;
  };

  Sided side_in(const Region& region) const noexcept;
  Sided side_of(const Vec3& x) noexcept;
  void descend(std::size_t depth, Sided sided);
  void find_supports_of(Siblings& cubes);
  void gather(const Siblings& cubes, std::size_t child, List& list) const noexcept;
  NearTriangles near(const List& list) const noexcept;
  void enter(std::size_t depth, std::size_t child, Sided sided);
  void finish(const Cube& cube, const List& list);
  /// Half the edge of a cube grown by what a point may be moved: lists have to hold for that.
  double grown_half(double size) const noexcept {
    return size / 2 + LeafPoints::grown_by * region_.final_size;
  }
  Vec3 from_middle(const Vec3& x) const noexcept {
    return {x.x - region_.middle.x, x.y - region_.middle.y, x.z - region_.middle.z};
  }

  const FieldData& field_;
  const Level& level_;
  Descent& single_;
  LeafTriangles triangles_;
  LeafPoints finished_;
  DescentCounts counts_;

  LeafRegion region_;
  std::array<Siblings, region_depth + 1> siblings_;  ///< by depth
  RegionPoints centres_;
  List small_;  ///< of a small cube
};

}  // namespace cdfr
