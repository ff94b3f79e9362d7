/// Where on a triangle the closest point lies, as far as plain double precision is sure of it. For most
/// points it is, and the kernel evaluates one feature.
#pragma once

#include <array>
#include <cstdint>

#include "cdfr/core/types.h"

namespace cdfr {

/// Where on the triangle the closest point lies: 0 the face; 1 + k edge k, from corner k to (k + 1) % 3; 4 +
/// k corner k.
using TrianglePlace = std::uint8_t;

inline constexpr TrianglePlace unsure_place = 7;

struct PlaceEstimate {
  /// Where the kernel certainly finds the foot; if it is an edge or a corner, the distance is certainly not
  /// zero. Else unsure_place, and the rest tells what is left to decide.
  TrianglePlace place = unsure_place;
  bool outside = false;                ///< the projection is certainly not inside all edges
  std::array<bool, 3> beside{};        ///< it is certainly inside edge k
  std::array<bool, 3> may_be_least{};  ///< no other edge is certainly closer than edge k
};

struct TriangleShape;

PlaceEstimate estimate_place(const Vec3& p, const TriangleShape& triangle) noexcept;

}  // namespace cdfr
