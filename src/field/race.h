/// Who is closest: computed distances compared, with an eye on those that rounding cannot tell apart.
#pragma once

#include <array>
#include <cstdint>

#include "cdfr/core/types.h"
#include "cdfr/octree/leaf.h"
#include "geometry/point_triangle.h"
#include "mesh/triangles.h"

namespace cdfr {

struct Winner {
  Foot foot;
  std::uint32_t slot = no_index;
  std::uint32_t number = no_index;
};

/// What a search brings home. Rounding may have put the winner before a feature that is closer in truth:
/// `rivals` are triangles on whose features the computed distance is as small but for rounding. The true
/// closest feature is among them or the winner's.
struct Finding {
  Winner winner;
  Side leaf = Side::undecided;  ///< side of the leaf that held p
  bool crowded = false;         ///< there are more rivals than these
  std::uint8_t rival_count = 0;
  std::array<std::uint32_t, 4> rivals{};  ///< slots: rare, so they are measured again by who asks
};

/// Who is closest so far. A triangle of no area wins only where nothing else is as close: if it is part of a
/// closed surface, proper triangles cover it, and their edges' distances differ from its own by rounding
/// alone.
class Race {
 public:
  /// `size` is at least the largest coordinate of p and of the mesh.
  Race(const Vec3& p, const TriangleStore& triangles, double size) noexcept
      : p_(p), triangles_(triangles), size_(size) {}

  /// The smaller computed squared distance stays, ties go to the lower number.
  void challenge(std::uint32_t slot) noexcept;
  Finding finding() const noexcept;

  /// Distances that differ by less than this may be in the other order in truth.
  static double gap(double size) noexcept { return 0x1p-88 * size; }
  static bool tied(DoubleDouble a, DoubleDouble b, double gap) noexcept;

 private:
  void challenge_proper(const Winner& challenger) noexcept;
  void add_rival(std::uint32_t slot) noexcept;
  /// Is that place of a triangle the edge or vertex on which the best foot lies?
  bool same_feature(TrianglePlace place, const TriangleRecord& record) const noexcept;
  bool shares_foot(TrianglePlace place, const TriangleRecord& record) const noexcept;

  Vec3 p_;
  const TriangleStore& triangles_;
  double size_;
  Finding proper_;
  Winner flat_;
};

}  // namespace cdfr
