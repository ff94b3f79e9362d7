// Solids of revolution.
#include <cmath>
#include <numbers>

#include "analysis/deep_levels.h"
#include "analysis/shapes.h"
#include "analysis/solids.h"

namespace cdfr::test {
namespace {

constexpr double pi = std::numbers::pi;

/// `deep` gives {depth > t}.
Shape revolved(const char* name, const Profile& profile, double chord,
               const std::function<std::vector<Profile>(double)>& deep, const std::vector<double>& depths) {
  const Revolution solid{profile};
  Shape shape{name,         solid.mesh(chord),
              chord,        solid.volume(),
              solid.area(), [solid](const Vec3& p) { return solid.depth(p); },
              {},           {},
              {},           {}};
  shape.levels = deep_levels(
      [&](double t) {
        std::vector<double> volumes;
        for (const Profile& part : deep(t)) volumes.push_back(Revolution{part}.volume());
        return volumes;
      },
      depths, chord);
  return shape;
}

/// About a point of the axis.
Profile half_disc(double radius) { return {{{{0, 0}, radius, -pi / 2, pi}}}; }

}  // namespace

Shape ball(double chord) {
  constexpr double radius = 3;
  Shape shape = revolved("ball", half_disc(radius), chord,
                         [](double t) { return std::vector{half_disc(radius - t)}; }, {0.5, 1.5, 2.5});
  shape.balls = {{{0, 0, 0}, radius, true}};
  for (const Vec3& n : {Vec3{0, 0, 1}, Vec3{0.6, 0, -0.8}, Vec3{-0.48, 0.64, 0.6}}) {
    shape.places.push_back({{radius * n.x, radius * n.y, radius * n.z}, n, 2 * radius, 2 * radius});
  }
  return shape;
}

// {depth > t} is the whole in small: in the half plane a triangle about the in-centre (0, r).
Shape cone(double chord) {
  constexpr double radius = 3, height = 4, slant = 5, r = radius * height / (radius + slant);
  const double slope = std::atan2(radius, height);  // of its normal
  const auto at = [=](double t) {
    const double share = 1 - t / r;
    const Profile part{{{{0, r - share * r}, 0, 0, 0},
                        {{share * radius, r - share * r}, 0, -pi / 2, pi / 2 + slope},
                        {{0, r + share * (height - r)}, 0, slope, pi / 2 - slope}}};
    return std::vector{part};
  };
  Shape shape = revolved("cone", at(0)[0], chord, at, {0.25, 0.75, 1.25});
  shape.balls = {{{0, 0, r}, r, true}};
  // Where the ball touches the slope; the ray from there goes on through its centre, down to the base.
  const Vec3 normal{height / slant, 0, radius / slant};
  shape.places = {{{0, 0, 0}, {0, 0, -1}, 2 * r, height},
                  {{r * normal.x, 0, r + r * normal.z}, normal, 2 * r, r * (slant + radius) / radius}};
  return shape;
}

Shape tube(double chord) {
  constexpr double inner = 4, outer = 6, length = 10, wall = outer - inner;
  const RoundedPolygon section{{{inner, 0}, {outer, 0}, {outer, length}, {inner, length}}, {0, 0, 0, 0}};
  Shape shape = revolved("tube", section.profile(), chord,
                         [=](double t) { return std::vector{section.inset(t).profile()}; }, {0.25, 0.75});
  shape.balls = {{{(inner + outer) / 2, 0, length / 2}, wall / 2, false}};
  shape.places = {{{0.8 * outer, 0.6 * outer, length / 2}, {0.8, 0.6, 0}, wall, wall},
                  {{0.8 * inner, 0.6 * inner, length / 2}, {-0.8, -0.6, 0}, wall, wall},
                  {{0.8 * (outer - wall / 2), 0.6 * (outer - wall / 2), 0}, {0, 0, -1}, wall, length}};
  return shape;
}

Shape torus(double chord) {
  constexpr double ring = 4, radius = 1.5;
  const auto disc = [](double r) { return Profile{{{{ring, 0}, r, 0, 2 * pi}}}; };
  Shape shape = revolved("torus", disc(radius), chord,
                         [=](double t) { return std::vector{disc(radius - t)}; }, {0.25, 0.75, 1.25});
  shape.balls = {{{ring, 0, 0}, radius, false}};
  shape.places = {{{ring + radius, 0, 0}, {1, 0, 0}, 2 * radius, 2 * radius},
                  {{ring - radius, 0, 0}, {-1, 0, 0}, 2 * radius, 2 * radius},
                  {{0, ring, radius}, {0, 0, 1}, 2 * radius, 2 * radius}};
  return shape;
}

// Two balls on the axis and between them a neck: an arc of radius f, concave, about a point A = n + f from
// the axis. It touches both, so their centres are sqrt((R + f)^2 - A^2) from the neck's plane. At depth t the
// arcs keep their centres; once t exceeds n the neck's arc meets the axis, and two parts remain.
Shape dumbbell(double chord) {
  constexpr double low = 3, high = 2, neck = 0.75, f = 2, away = neck + f;
  const double low_z = std::sqrt((low + f) * (low + f) - away * away);
  const double high_z = std::sqrt((high + f) * (high + f) - away * away);
  const double low_turn = std::atan2(low_z, away), high_turn = std::atan2(high_z, away);
  const auto deep = [=](double t) -> std::vector<Profile> {
    const Arc lower{{0, -low_z}, low - t, -pi / 2, pi / 2 + low_turn};
    const Arc upper{{0, high_z}, high - t, -high_turn, pi / 2 + high_turn};
    const auto concave = [&](double from, double to) { return Arc{{away, 0}, f + t, from, to - from}; };
    if (t < neck) return {{{lower, concave(pi + low_turn, pi - high_turn), upper}}};
    const double open = std::acos(away / (f + t));
    const Profile first{{lower, concave(pi + low_turn, pi + open)}};
    if (t > high) return {first};
    return {first, {{concave(pi - open, pi - high_turn), upper}}};
  };
  Shape shape = revolved("dumbbell", deep(0)[0], chord, deep, {0.5, 1, 1.5, 2.5});
  shape.balls = {{{0, 0, -low_z}, low, true}, {{0, 0, high_z}, high, true}};
  shape.necks = {{{0, 0, 0}, neck}};
  shape.places = {{{0, 0, -low_z - low}, {0, 0, -1}, 2 * low, low + low_z + high_z + high},
                  {{0, 0, high + high_z}, {0, 0, 1}, 2 * high, low + low_z + high_z + high},
                  {{neck, 0, 0}, {1, 0, 0}, 2 * neck, 2 * neck}};
  return shape;
}

}  // namespace cdfr::test
