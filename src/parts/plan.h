/// One triangulation of a part's footprint that has every outline of every height among its sides.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "parts/outline.h"

namespace cdfr {

struct Plan {
  std::vector<PlanPoint> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< counter-clockwise
};

/// The footprint reaches from (0, 0) to `far`; outlines stay inside it. Sides and triangles are about
/// `spacing` mm long; no two points are closer than 1/4 mm where outlines cross. Outlines are cut where they
/// cross and where they touch.
Plan make_plan(PlanPoint far, std::span<const Outline> outlines, double spacing);

}  // namespace cdfr
