/// The triangle closest to a point, and all that belongs to it.
#pragma once

#include <cstdint>

#include "cdfr/field/field.h"
#include "field/field_data.h"
#include "geometry/point_triangle.h"

namespace cdfr {

struct Winner {
  Foot foot;
  Side side = Side::undecided;  ///< of the leaf that held p
  std::uint32_t slot = no_index;
  std::uint32_t number = no_index;
};

/// Who is closest so far. A triangle of no area wins only where nothing else is as close: if it is part of a
/// closed surface, proper triangles cover it, and their edges' distances differ from its own by rounding
/// alone.
class Race {
 public:
  Race(const Vec3& p, const TriangleStore& triangles) noexcept : p_(p), triangles_(triangles) {}

  /// The smaller computed squared distance stays, ties go to the lower number.
  void challenge(std::uint32_t slot) noexcept;
  Winner winner() const noexcept;

 private:
  Vec3 p_;
  const TriangleStore& triangles_;
  Winner proper_;
  Winner flat_;
};

/// By the leaf's list in the domain, by the BVH beyond. Precondition: p is finite, within largest_query,
/// without dust.
Winner find_winner(const FieldData& field, const Vec3& p) noexcept;

/// By every triangle, without a tree.
Winner find_winner_brute(const FieldData& field, const Vec3& p) noexcept;

enum class Finder { tree, brute };

double signed_distance(const FieldData& field, const Vec3& x) noexcept;
double unsigned_distance(const FieldData& field, const Vec3& x) noexcept;
Closest closest_point(const FieldData& field, const Vec3& x, Finder finder) noexcept;

}  // namespace cdfr
