/// From a leaf to its heavy cells.
///
/// **Bounds.** Let c be a cube's centre, a half its edge, h half its diagonal, y = x - c for a point x of it.
/// For each triangle of a list that is complete for the cube let d_k be the distance from c and g_k the unit
/// vector from its foot to c. The distance to a triangle is convex, so
///     d(x, T_k) >= d_k + g_k.y =: l_k(x),   and   d(x) >= min over k of l_k(x).
/// Let T_0 be the closest. Compared with its plane l_0 the others are lower by at most
///     below = max over k of  a |g_k - g_0|_1 - (d_k - d_0),
/// and triangles for which that is negative by more than `above` are closest nowhere in the cube: they leave
/// its list. Upwards, x is no farther than the foot of c. Let the foot be inside its triangle by i (0 on its
/// border). The projection of x is beyond the triangle by o <= max(0, h - i), at a height l_0(x) >= d_0 - h,
/// so
///     d(x) <= sqrt(l_0^2 + o^2) <= l_0(x) + o^2 / (2 (d_0 - h)) =: l_0(x) + above.
/// At the border the foot takes the place of the triangle, with i = 0. Between walls the mean of two such
/// bounds is sharper than each (field/distance_above.h). Near the surface, at less than 9/8 h, the slope of 1
/// has to do: the depth is within h of the centre's.
///
/// A cube is dropped if it is nowhere deeper than T; it becomes a cell if all of it is, if above + below is
/// within Threshold::flat, or if h <= e; else it is halved. Any point deeper than T + rounding is in the
/// possible part of some cell, and each cell's possible part is deeper than T - 2 e.
///
/// Rounding: feet are off by TriangleFrame::error (geometry/feet.h), directions by that over d_0 > 9/8 h, so
/// bounds by less than 2 errors; these are added on both sides.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "analysis/heavy_cell.h"
#include "core/progress.h"
#include "field/field_data.h"
#include "geometry/cube.h"
#include "geometry/feet.h"

namespace cdfr {

/// The triangle of that slot may be closest to a point of the cell, and of others that are surely of the same
/// section.
struct CellTriangle {
  std::uint32_t cell, slot;
};

struct HeavyCells {
  std::vector<HeavyCell> cells;         ///< in Morton order
  std::vector<CellTriangle> triangles;  ///< of cells that are not inner
  std::uint64_t looks = 0;              ///< cubes looked at
};

class HeavyDescent {
 public:
  HeavyDescent(const FieldData& field, const Threshold& threshold, HeavyCells& out, Progress& progress)
      : field_(field),
        threshold_(threshold),
        rule_(threshold, field.tree.lattice),
        out_(out),
        progress_(progress) {}

  /// A leaf of the octree, or a cell in it, whose list is the leaf's.
  void run(const Cell& cell, std::span<const Entry> list, Side side);
  /// The same for a cell that has been found before, to a finer threshold: it is halved at least once.
  void refine(const Cell& cell);

 private:
  enum class Sided : std::uint8_t { open, inside, outside };
  /// What is known of a cube.
  struct Outlook {
    double distance = 0;  ///< of the centre
    Vec3 gradient;        ///< none if nothing but the slope of 1 is known
    double below = 0, above = 0;
    double least = 0, most = 0;
  };
  enum class Fate : std::uint8_t { drop, keep, halve };
  /// A cube with what is to become of it.
  struct Seen {
    Fate fate = Fate::drop;
    Sided sided = Sided::open;
    Outlook outlook;
    std::vector<std::uint16_t> numbers;  ///< its list
  };
  using Octants = std::array<Seen, 8>;

  Sided side_at(const Vec3& centre, double distance, double half_diagonal) const noexcept;
  bool gather(std::span<const Entry> list);
  bool gather_near(const Cube& cube, double distance);
  void take_list(const Cube& region);
  void look_at(const Cell& cell, Sided sided);
  void settle(const Cell& cell, const Seen& seen);
  void descend(const Cell& cell, const Seen& seen);
  void descend_blind(const Cell& cell, Sided sided);
  void measure(std::span<const std::uint16_t> numbers);
  void see(std::size_t point, double size, std::span<const std::uint16_t> numbers, Sided above, Seen& seen);
  void compare(double size, std::span<const std::uint16_t> numbers);
  Outlook outlook(std::size_t point, double size, std::span<const std::uint16_t> numbers,
                  std::vector<std::uint16_t>& kept) const;
  double rise(std::size_t place, std::size_t point, std::uint16_t number,
              double half_diagonal) const noexcept;
  double most_between(std::size_t point, double size, std::span<const std::uint16_t> numbers) const noexcept;
  Vec3 gradient(std::size_t place, std::size_t point) const noexcept {
    const EightFeet& eight = eights_[place];
    return {eight.away[0][point], eight.away[1][point], eight.away[2][point]};
  }
  Outlook blind(const Cube& cube) const noexcept;
  Fate fate_of(const Outlook& outlook, Sided sided, double half_diagonal) const noexcept;
  void put(const Cell& cell, const Seen& seen);
  void tell(std::uint32_t slot, const HeavyCell& cell);
  Cube cube_of(const Cell& cell) const noexcept;

  const FieldData& field_;
  const Threshold& threshold_;
  CoreRule rule_;
  HeavyCells& out_;
  Progress& progress_;
  std::vector<CellTriangle> told_ = std::vector<CellTriangle>(1024, {no_index, no_index});  ///< last, by slot

  // Of the list.
  Vec3 middle_;
  double error_ = 0;  ///< of what is made of feet
  std::vector<std::uint32_t> slots_;
  std::vector<TriangleFrame> frames_;
  std::vector<std::uint16_t> all_;

  // Of the cubes that are looked at: one, or the octants of one.
  RegionPoints centres_{};
  std::vector<EightFeet> eights_;             ///< one for each of the numbers
  std::vector<std::array<double, 8>> lower_;  ///< by how much its l_k may be below l_0
  std::array<std::size_t, 8> first_{};        ///< the closest one's place among the numbers
  std::array<double, 8> least_{};             ///< of all l_k in the cubes
  std::vector<Octants> levels_{std::size_t{deepest_level} + 2};  ///< by level, to keep their memory
};

}  // namespace cdfr
