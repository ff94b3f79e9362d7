/// The volume of what is closest to some of the triangles, bounded from both sides.
///
/// A cube is halved until it is decided. In a cube of centre c and half diagonal h the triangles that can be
/// closest are known (field/near_triangles.h). If none of them is marked, or all of the cube is outside, it
/// holds no material; if all of them are marked and all of the cube is inside, it is material as a whole.
///
/// **At the surface** the planes of those triangles bound what is inside. Let x be outside and q its closest
/// point. Around q the triangles that touch it cut space into sectors; the way from x ends in one of them,
/// and the great circle from its direction to the nearest arc of that sector's border comes from the front of
/// the arc's triangle, so, being shorter than half a turn, starts in front of it: some triangle that is
/// closest to x has x in front of its plane. In the same way x inside is behind one. So the inside of the
/// cube holds all that is behind every plane, and nothing that is in front of every plane; that needs only
/// that each triangle has the outside in front and the inside behind. With depths below the planes o_k +
/// w_k.y and o + w.y the middle of them, all are within
///     spread = max |o_k - o| + a sum over axes of max |w_k - w|
/// of the middle one, a being half the cube's edge: inside lies {o + w.y > spread} and no more than {o + w.y
/// > -spread}, volumes that cut_cube.h gives. Planes that are one leave no doubt, and on a curved surface the
/// spread falls with the square of h.
///
/// A cube that is still mixed at the last level, with triangles that are marked and others, holds anything
/// from nothing to all of its inside.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/progress.h"
#include "field/field_data.h"
#include "field/near_triangles.h"
#include "geometry/cube.h"

namespace cdfr {

/// A volume that is at least one thing and at most another.
struct Material {
  double sure = 0, possible = 0;
};

struct MaterialSearch {
  std::span<const std::uint8_t> marked;  ///< a byte for each slot
  Box box;                               ///< of the marked triangles
  int level = 0;                         ///< of the smallest cells
  double flat = 0;                       ///< planes within this of their middle are not told apart
};

class MaterialDescent {
 public:
  MaterialDescent(const FieldData& field, const MaterialSearch& search, Progress& progress);

  /// What of a cell of the lattice is closest to marked triangles. Precondition: the field is signed.
  Material run(const Cell& cell) {
    found_ = {};
    descend(cell, nullptr, false);
    return found_;
  }

 private:
  /// What triangles tell of the inside of a cube.
  struct Inside {
    Material volume;
    double spread = 0;
  };

  void descend(const Cell& cell, const std::vector<std::uint32_t>* among, bool inside);
  bool look(const Cube& cube, double distance, const std::vector<std::uint32_t>* among);
  std::size_t count_marked() const noexcept;
  bool is_outward(std::uint32_t slot) const noexcept;
  Inside inside_by_planes(const Cube& cube) const noexcept;
  void add(const Material& more) noexcept {
    found_.sure += more.sure;
    found_.possible += more.possible;
  }

  const FieldData& field_;
  const MaterialSearch& search_;
  Progress& progress_;
  double rounding_;
  std::vector<NearTriangle> near_;
  Material found_;
};

}  // namespace cdfr
