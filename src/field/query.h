/// The triangle closest to a point, and all that belongs to it.
#pragma once

#include <array>
#include <cstdint>

#include "cdfr/field/field.h"
#include "field/field_data.h"
#include "geometry/point_triangle.h"

namespace cdfr {

struct Winner {
  Foot foot;
  std::uint32_t slot = no_index;
  std::uint32_t number = no_index;
};

/// What a search brings home. Rounding may have put the winner before a feature that is closer in truth:
/// `rivals` are other features whose computed distance is as small but for rounding. The true closest one is
/// among them.
struct Finding {
  Winner winner;
  Side leaf = Side::undecided;  ///< side of the leaf that held p
  bool crowded = false;         ///< there are more rivals than these
  std::uint8_t rival_count = 0;
  std::array<Winner, 4> rivals;
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

 private:
  void challenge_proper(const Winner& challenger) noexcept;
  void add_rival(const Winner& loser) noexcept;
  bool same_feature(const Winner& a, const Winner& b) const noexcept;

  Vec3 p_;
  const TriangleStore& triangles_;
  double size_;
  Finding proper_;
  Winner flat_;
};

/// Largest coordinate of p and the mesh.
double size_of(const FieldData& field, const Vec3& p) noexcept;

/// By the leaf's list in the domain, by the BVH beyond. Precondition: p is finite, within largest_query,
/// without dust.
Finding find_closest(const FieldData& field, const Vec3& p) noexcept;

/// By every triangle, without a tree.
Finding find_closest_brute(const FieldData& field, const Vec3& p) noexcept;

enum class Finder { tree, brute };

double signed_distance(const FieldData& field, const Vec3& x) noexcept;
double unsigned_distance(const FieldData& field, const Vec3& x) noexcept;
Closest closest_point(const FieldData& field, const Vec3& x, Finder finder) noexcept;

}  // namespace cdfr
