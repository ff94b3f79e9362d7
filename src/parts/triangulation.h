/// Triangles over a polygon with holes, on its own corners alone.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "parts/outline.h"

namespace cdfr {

/// The greedy triangulation: the shortest diagonal that crosses none before it, until none is left (Preparata
/// and Shamos, Computational Geometry, 1985, section 6.2); of equally long ones the first. Exact, so nothing
/// depends on rounding. The first loop is the polygon's outline, the others are holes in it, all
/// counter-clockwise; they touch neither each other nor themselves. Corners are numbered through the loops,
/// triangles run counter-clockwise. n corners and h holes give n + 2 h - 2 triangles. O(n^2 log n) and at
/// worst O(n^3).
std::vector<std::array<std::uint32_t, 3>> triangulate(std::span<const Outline> loops);

}  // namespace cdfr
