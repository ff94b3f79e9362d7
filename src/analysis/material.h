/// The volume of what is closest to some of the triangles, bounded from both sides.
///
/// A cube is halved until it is decided. In a cube of centre c and half diagonal h the triangles that can be
/// closest are known (field/near_triangles.h). If none of them is marked, or all of the cube is outside, it
/// holds no material; if all of them are marked and all of the cube is inside, it is material as a whole.
///
/// **At the surface** the planes of those triangles that come into the cube bound what is inside. Let x be a
/// point of the cube outside, and q the closest to it of the surface in the cube: nothing is met on the way.
/// Around q the triangles that touch it cut space into sectors; the way from x ends in one of them, and the
/// great circle from its direction to the nearest arc of that sector's border comes from the front of the
/// arc's triangle, so, being shorter than half a turn, starts in front of it: some triangle in the cube has x
/// in front of its plane. In the same way x inside is behind one. So the inside of the cube holds all that is
/// behind every plane, and nothing that is in front of every plane; that needs only that each triangle has
/// the outside in front and the inside behind, and that sides change on the surface alone. The depths below
/// the planes are linear: plane_range.h bounds the volume. Planes that are one leave no doubt, and on a
/// curved surface the doubt falls with the square of h. Without a triangle the cube is on one side.
///
/// **Inside, between marked triangles and others.** Let d be the distance of c from a triangle, g the unit
/// vector from its foot to c, y = x - c. As in heavy_descent.h
///     d + g.y <= distance of x <= d + g.y + h^2 / (2 (d - h)).
/// The distance to the marked ones is therefore no less than the least of their tangents, and no more than
/// that of the closest one with the square term; the same for the others. Material is where the difference is
/// above 0: between two ranges of linear functions again.
///
/// What is neither, where those sheets meet the surface, holds anything from nothing to all of its inside at
/// the last level.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "analysis/plane_range.h"
#include "core/progress.h"
#include "field/field_data.h"
#include "field/near_triangles.h"
#include "geometry/cube.h"

namespace cdfr {

struct MaterialSearch {
  std::span<const std::uint8_t> marked;  ///< a byte for each slot
  Box box;                               ///< of the marked triangles
  int level = 0;                         ///< of the smallest cells
  double flat = 0;                       ///< bounds this far from their middle are close enough
};

class MaterialDescent {
 public:
  MaterialDescent(const FieldData& field, const MaterialSearch& search, Progress& progress);

  /// What of a cell of the lattice is closest to marked triangles. Precondition: the field is signed.
  VolumeBounds run(const Cell& cell) {
    found_ = {};
    descend(cell, nullptr, false);
    return found_;
  }

 private:
  /// What triangles tell of a cube: all of it may count, if they tell nothing.
  struct Cut {
    VolumeBounds volume;
    double spread = 0;
  };

  void descend(const Cell& cell, const std::vector<std::uint32_t>* among, bool inside);
  bool look(const Cube& cube, double distance, const std::vector<std::uint32_t>* among);
  std::size_t count_marked() const noexcept;
  bool is_outward(std::uint32_t slot) const noexcept;
  Cut cut(const Cube& cube, bool inside, bool all) const noexcept;
  Cut inside_by_planes(const Cube& cube) const noexcept;
  Cut closer_to_marked(const Cube& cube) const noexcept;

  const FieldData& field_;
  const MaterialSearch& search_;
  Progress& progress_;
  double rounding_;  ///< of distances
  std::vector<NearTriangle> near_;
  VolumeBounds found_;
};

}  // namespace cdfr
