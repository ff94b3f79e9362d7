#include "parts/outline.h"

#include <cstddef>
#include <cstdint>

#include "core/arithmetic.h"

namespace cdfr {
namespace {

std::int64_t nearest(double value) noexcept {
  return static_cast<std::int64_t>(value * plan_units + (value < 0 ? -0.5 : 0.5));
}

bool close(PlanPoint a, PlanPoint b) noexcept {
  const std::int64_t x = a.x - b.x;
  const std::int64_t y = a.y - b.y;
  constexpr std::int64_t half_millimetre = 512;
  return x * x + y * y < half_millimetre * half_millimetre;
}

constexpr double two_pi = 0x1.921fb54442d18p+2;

PlanPoint on_circle(double x, double y, double radius, int step, int steps) noexcept {
  const double angle = two_pi * step / steps;
  return plan_point(x + radius * cosine(angle), y + radius * sine(angle));
}

PlanPoint crossing(PlanPoint from, PlanPoint to, std::int64_t from_side, std::int64_t to_side) noexcept {
  const double share = static_cast<double>(from_side) / static_cast<double>(from_side - to_side);
  return plan_point((static_cast<double>(from.x) + share * static_cast<double>(to.x - from.x)) / plan_units,
                    (static_cast<double>(from.y) + share * static_cast<double>(to.y - from.y)) / plan_units);
}

}  // namespace

PlanPoint plan_point(double x, double y) noexcept { return {nearest(x), nearest(y)}; }

Outline rectangle(double x_low, double y_low, double x_high, double y_high) {
  return {plan_point(x_low, y_low), plan_point(x_high, y_low), plan_point(x_high, y_high),
          plan_point(x_low, y_high)};
}

Outline rounded(double x_low, double y_low, double x_high, double y_high, double radius, int pieces) {
  Outline outline;
  for (int i = 0; i < 4; ++i) {
    const double x = i == 0 || i == 3 ? x_high - radius : x_low + radius;
    const double y = i < 2 ? y_high - radius : y_low + radius;
    for (int k = 0; k <= pieces; ++k) outline.push_back(on_circle(x, y, radius, i * pieces + k, 4 * pieces));
  }
  return outline;
}

Outline disc(double x, double y, double radius, int corners) {
  Outline outline;
  for (int i = 0; i < corners; ++i) outline.push_back(on_circle(x, y, radius, i, corners));
  return outline;
}

Outline left_part(const Outline& outline, PlanPoint a, PlanPoint b) {
  Outline cut;
  std::vector<PlanPoint> crossings;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const PlanPoint from = outline[i];
    const PlanPoint to = outline[(i + 1) % outline.size()];
    const std::int64_t from_side = turn(a, b, from);
    const std::int64_t to_side = turn(a, b, to);
    if (from_side >= 0) cut.push_back(from);
    if ((from_side < 0 && to_side > 0) || (from_side > 0 && to_side < 0)) {
      crossings.push_back(crossing(from, to, from_side, to_side));
      cut.push_back(crossings.back());
    }
  }
  Outline kept;
  for (const PlanPoint point : cut) {
    bool sliver = false;
    for (const PlanPoint other : crossings) sliver = sliver || (point != other && close(point, other));
    if (!sliver) kept.push_back(point);
  }
  return kept;
}

bool holds_middle(const Outline& outline, PlanPoint a, PlanPoint b, PlanPoint c) noexcept {
  const PlanPoint middle{a.x + b.x + c.x, a.y + b.y + c.y};  // three times the plan's scale
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const PlanPoint from = outline[i];
    const PlanPoint to = outline[(i + 1) % outline.size()];
    if (turn({3 * from.x, 3 * from.y}, {3 * to.x, 3 * to.y}, middle) < 0) return false;
  }
  return true;
}

}  // namespace cdfr
