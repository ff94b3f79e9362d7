/// Heavy sections the slow way: a dense grid of exact distances over the whole part, and the fact that depth
/// changes no faster than one moves.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "cdfr/field/field.h"
#include "oracle/range.h"

namespace cdfr::oracle {

/// Samples around which the depth may exceed T, joined to those of all 26 neighbours that are so as well: a
/// set of cubes that holds one or more components of {depth > T} whole.
struct SectionPatch {
  Range volume;        ///< of what is deeper than T in it
  double counted = 0;  ///< its cubes, those at the border by how deep their sample is: most likely close
  Range radius;        ///< of its largest ball, in parts of the grid and by ascent from the best samples
  Vec3 deepest;        ///< where the ascent ended
  Box box;             ///< of its cubes: holds all that is deeper
  std::size_t parts =
      0;  ///< sets of samples deeper than T that are joined for certain: see SectionGrid::part
};

/// The part on a grid of about `samples` cubes.
class SectionGrid {
 public:
  SectionGrid(const Field& field, double depth, std::size_t samples);

  /// In the order of their first samples. A patch may hold nothing deeper than T: then its volume's and its
  /// radius's low ends are 0.
  const std::vector<SectionPatch>& patches() const noexcept { return patches_; }
  double spacing() const noexcept { return grid_.spacing.x; }
  /// Half the diagonal of a cube: no point of it is farther from its sample.
  double reach() const noexcept;

  static constexpr std::uint32_t none = 0xffffffff;
  /// The patch whose cubes hold that point.
  std::uint32_t patch(const Vec3& p) const;
  /// The joined part that the sample closest to p belongs to; none if that is not deeper than T. Two samples
  /// of one part are in one section for certain: on the way from one to the next, a and b deep and s apart,
  /// it is nowhere less deep than (a + b - s) / 2, and that exceeds T.
  std::uint32_t part(const Vec3& p) const;

 private:
  std::size_t nearest(const Vec3& p) const;
  template <class Joins>
  std::vector<std::uint32_t> components(Joins joins) const;
  void measure();
  void ascend(std::uint32_t number, std::size_t from);

  const Field& field_;
  double depth_;
  Grid grid_;
  std::vector<double> depths_;
  std::vector<std::uint32_t> patch_of_, part_of_;
  std::vector<SectionPatch> patches_;
};

}  // namespace cdfr::oracle
