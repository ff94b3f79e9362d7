/// Convex outlines in a plan: what walls, bosses and bores look like from above.
#pragma once

#include <vector>

#include "parts/delaunay.h"

namespace cdfr {

/// In a unit of the recipe, which is a millimetre if it does not say another.
inline constexpr double plan_units = 1024;

PlanPoint plan_point(double x, double y) noexcept;

/// Corners counter-clockwise, the polygon convex.
using Outline = std::vector<PlanPoint>;

Outline rectangle(double x_low, double y_low, double x_high, double y_high);

/// A rectangle whose corners are rounded with `radius`, each by `pieces` sides.
Outline rounded(double x_low, double y_low, double x_high, double y_high, double radius, int pieces);

/// A regular polygon with its corners on the circle, one of them at angle 0. With a multiple of four its
/// extent in x and y is the circle's.
Outline disc(double x, double y, double radius, int corners);

/// The part of a convex outline on the left of the line from `a` to `b`. A corner closer than 1/2 mm to where
/// the line cuts is left out: it would make a sliver.
Outline left_part(const Outline& outline, PlanPoint a, PlanPoint b);

/// Whether the middle of the triangle is inside or on the border: exact.
bool holds_middle(const Outline& outline, PlanPoint a, PlanPoint b, PlanPoint c) noexcept;

}  // namespace cdfr
