/// The triangle closest to a point, and all that belongs to it.
#pragma once

#include <cstdint>

#include "cdfr/field/field.h"
#include "field/field_data.h"
#include "geometry/point_triangle.h"

namespace cdfr {

struct Winner {
  Foot foot;
  std::uint32_t slot = no_index;
  std::uint32_t number = no_index;

  /// Keeps the smaller computed squared distance, ties to the lower number.
  void challenge(const Vec3& p, std::uint32_t candidate, const TriangleStore& triangles) noexcept;
};

/// By the leaf's list in the domain, by the BVH beyond. Precondition: p is finite, within largest_query,
/// without dust.
Winner find_winner(const FieldData& field, const Vec3& p) noexcept;

/// By every triangle.
Winner find_winner_brute(const FieldData& field, const Vec3& p) noexcept;

enum class Finder { tree, brute };

double signed_distance(const FieldData& field, const Vec3& x) noexcept;
Closest closest_point(const FieldData& field, const Vec3& x, Finder finder) noexcept;

}  // namespace cdfr
