/// The range of numbers in which the arithmetic of this room is exact or bounded, and how a query is brought
/// into it.
#pragma once

#include <cmath>

#include "cdfr/core/types.h"

namespace cdfr {

/// Mesh coordinates are 0 or within these sizes, hence multiples of 2^-252.
inline constexpr double smallest_coordinate = 0x1p-200;
inline constexpr double largest_coordinate = 0x1p200;

/// Query coordinates below this size are taken as 0. A mesh has a coordinate of at least 2^-200 unless it is
/// the origin itself, so the shift is below 2^-47 ulp. What remains is a multiple of 2^-352; a product of one
/// query difference and two mesh differences is a multiple of 2^-856, of two query differences and one mesh
/// difference of 2^-956, of three query differences of 2^-1056: no underflow in exact arithmetic.
inline constexpr double smallest_query = 0x1p-300;

/// Beyond this a query is at a distance of 2^100 times the largest mesh and more: every point of the mesh is
/// equally close to far less than an ulp. Products stay finite below it.
inline constexpr double largest_query = 0x1p300;

inline bool is_finite(const Vec3& p) noexcept {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

inline double largest_magnitude(const Vec3& p) noexcept {
  return std::fmax(std::fabs(p.x), std::fmax(std::fabs(p.y), std::fabs(p.z)));
}

/// 16 ulp of the largest coordinate in play: what a distance (the kernel's 4) and the arithmetic of one point
/// may be off by.
inline double point_rounding(double largest) noexcept {
  return 16 * std::ldexp(1.0, std::ilogb(largest) - 52);
}

/// Precondition: p is finite.
inline Vec3 without_dust(const Vec3& p) noexcept {
  const auto clean = [](double v) { return std::fabs(v) < smallest_query ? 0.0 : v; };
  return {clean(p.x), clean(p.y), clean(p.z)};
}

}  // namespace cdfr
