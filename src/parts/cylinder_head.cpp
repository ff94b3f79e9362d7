#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "parts/layers.h"
#include "parts/made_parts.h"
#include "parts/rise.h"

namespace cdfr {
namespace {

constexpr double length = 480, width = 266, height = 157;
constexpr double wall = 9;
constexpr double middle = 133;  ///< the cylinders' row in y
constexpr std::array<double, 4> cylinders{78, 186, 294, 402};
constexpr std::array<double, 5> bolt_rows{23, 132, 240, 348, 457};

/// Heights of the storeys, from the face on the engine block up.
namespace level {
constexpr double face = 0, deck = 9, roof = 18, port_floor = 31, port_low = 40, port_high = 58,
                 port_roof = 67, oil_floor = 76, oil_deck = 85, guide_top = 94, screw = 98, bearing = 106,
                 rail = 112, top = height;
}  // namespace level

constexpr double chamber = 42, valve = 13, stem = 3.5, bolt = 6, boss = 15;
constexpr double valve_offset = 18, port_half = 18, shaft_offset = 48;

/// The four valves of a cylinder: intake ports open to y = 0, exhaust ports to y = width.
std::array<Vec3, 4> valves(double x) {
  return {{{x - valve_offset, middle - valve_offset, 0},
           {x + valve_offset, middle - valve_offset, 0},
           {x - valve_offset, middle + valve_offset, 0},
           {x + valve_offset, middle + valve_offset, 0}}};
}

Outline port(double x, double half, bool intake) {
  return intake ? rectangle(x - half, 0, x + half, middle - valve_offset)
                : rectangle(x - half, middle + valve_offset, x + half, width);
}

void add_shell(Recipe& recipe) {
  const Outline room = rounded(wall, wall, length - wall, width - wall, 24 - wall, 6);
  recipe.fill(rounded(0, 0, length, width, 24, 6), level::face, level::rail);
  recipe.empty(room, level::deck, level::oil_floor);
  recipe.empty(room, level::oil_deck, level::rail);
}

/// Between the ports the long walls stand 6 mm back, so that the ports end in flanges. The wall overlaps
/// itself by its own thickness where it steps.
void add_recesses(Recipe& recipe) {
  constexpr double back = 6;
  for (std::size_t i = 0; i + 1 < cylinders.size(); ++i) {
    const double low = cylinders[i] + 42;
    const double high = cylinders[i + 1] - 42;
    recipe.fill(rectangle(low - wall, wall, high + wall, wall + back), level::deck, level::oil_floor);
    recipe.empty(rectangle(low, 0, high, back), level::deck, level::oil_floor);
    recipe.fill(rectangle(low - wall, width - wall - back, high + wall, width - wall), level::deck,
                level::oil_floor);
    recipe.empty(rectangle(low, width - back, high, width), level::deck, level::oil_floor);
  }
}

/// Chamber roof and rim, ports with their bowls, valve guides, the injector's tube and its well, cam
/// bearings.
void fill_cylinder(Recipe& recipe, double x) {
  recipe.fill(disc(x, middle, chamber + wall, 72), level::face, level::roof);
  for (const bool intake : {true, false})
    recipe.fill(port(x, port_half + wall, intake), level::port_floor, level::port_roof);
  for (const Vec3& v : valves(x)) {
    recipe.fill(disc(v.x, v.y, valve + wall, 32), level::roof, level::port_roof);
    recipe.fill(disc(v.x, v.y, 11, 20), level::port_roof, level::oil_floor);
    recipe.fill(disc(v.x, v.y, 9, 20), level::oil_deck, level::guide_top);
  }
  recipe.fill(disc(x, middle, 12, 24), level::roof, level::oil_floor);
  recipe.fill(disc(x, middle, 20, 32), level::oil_deck, level::top);
  for (const double y : {wall, width - 101}) {
    recipe.fill(rectangle(x - 4.5, y, x + 4.5, y + 92), level::oil_deck, level::bearing);
  }
  for (const double shaft : {middle - shaft_offset, middle + shaft_offset}) {
    for (double y = shaft - 12; y < shaft + 12; y += 4) {  // lines of the plan across the bearing's hollow
      recipe.fill(rectangle(x - 4.5, y, x + 4.5, y + 4), level::oil_deck, level::bearing);
    }
  }
}

void empty_cylinder(Recipe& recipe, double x) {
  recipe.empty(disc(x, middle, chamber, 64), level::face, level::deck);
  for (const bool intake : {true, false})
    recipe.empty(port(x, port_half, intake), level::port_low, level::port_high);
  for (const Vec3& v : valves(x)) {
    recipe.empty(disc(v.x, v.y, valve, 24), level::deck, level::port_high);
    recipe.empty(disc(v.x, v.y, stem, 12), level::port_high, level::guide_top);
  }
  recipe.empty(disc(x, middle, stem, 12), level::deck, level::oil_deck);
  recipe.empty(disc(x, middle, 12, 24), level::oil_deck, level::top);
  for (const double side : {-28.5, 28.5}) {  // water from the engine block
    recipe.empty(disc(x + side, middle - 52, stem, 12), level::face, level::deck);
    recipe.empty(disc(x + side, middle + 52, stem, 12), level::face, level::deck);
  }
}

/// Columns with a bore through both decks, for the head bolts.
std::vector<Vec3> bolts() {
  std::vector<Vec3> result;
  for (const double x : bolt_rows) {
    result.push_back({x, 71, 0});
    result.push_back({x, 195, 0});
  }
  return result;
}

/// Bosses for the cover's screws on the inside of the upper walls.
void add_cover_screws(Recipe& recipe) {
  const PlanPoint a = plan_point(wall, wall);
  const PlanPoint b = plan_point(length - wall, wall);
  const PlanPoint c = plan_point(length - wall, width - wall);
  const PlanPoint d = plan_point(wall, width - wall);
  const auto inside = [&](double x, double y) {
    return left_part(left_part(left_part(left_part(disc(x, y, 12.5, 24), a, b), b, c), c, d), d, a);
  };
  std::vector<Vec3> places{{14, middle, 0}, {length - 14, middle, 0}};
  for (const double x : {132.0, 240.0, 348.0}) {
    places.push_back({x, 14, 0});
    places.push_back({x, width - 14, 0});
  }
  for (const Vec3& p : places) {
    recipe.fill(inside(p.x, p.y), level::screw, level::rail);
    recipe.empty(disc(p.x, p.y, stem, 16), level::screw, level::rail);
  }
}

/// The one heavy section, in the water jacket between the exhaust ports of the middle cylinders: a block 19
/// mm thick, 26 long and 36 high, held by 9 mm webs at its two ends. Both sides, x = 240 +- 9.5, are free and
/// whole, so no ball in it is larger than 9.5, and one of 9.5 fits wherever the middle plane is as far from
/// top, bottom and ends: from y = 226.5 to 233.5 and from z = 40.5 to 57.5 (in y a little more, for a web's
/// root is an edge 4.5 off the plane: 9.5^2 - 4.5^2 = 8.37^2). The centre is (240, 230, 49). Were a deck or
/// wall in touch with the sides, or a plate of another thickness below, the root of the joint would hold a
/// larger ball.
void add_heavy_section(Recipe& recipe) {
  recipe.fill(rectangle(235.5, 206, 244.5, width - wall), level::port_floor, level::port_roof);
  recipe.fill(rectangle(230.5, 217, 249.5, 243), level::port_floor, level::port_roof);
}

std::vector<Step> recipe_steps() {
  Recipe recipe;
  add_shell(recipe);
  add_recesses(recipe);
  for (const double x : cylinders) fill_cylinder(recipe, x);
  for (const Vec3& c : bolts()) recipe.fill(disc(c.x, c.y, boss, 24), level::deck, level::oil_floor);
  add_heavy_section(recipe);
  for (const double x : cylinders) empty_cylinder(recipe, x);
  for (const Vec3& c : bolts()) recipe.empty(disc(c.x, c.y, bolt, 16), level::face, level::oil_deck);
  add_cover_screws(recipe);
  for (const double x : {0.0, length - wall}) {  // core holes in the ends
    recipe.empty(rectangle(x, middle - 8.75, x + wall, middle + 8.75), level::port_low, level::port_high);
  }
  return std::move(recipe.steps);
}

/// How far the recipe's storeys rise over a point of the plan, so that chambers are domed, ports oval and
/// rising outward, core holes round and cam bearings hollow.
struct Storeys {
  double dome = 0, port_floor = 0, port_roof = 0, bearing = 0;
};

Storeys storeys_at(double x, double y) {
  Storeys rise;
  for (const double cylinder : cylinders) {
    const double across = std::abs(x - cylinder);
    const double along = std::abs(y - middle);
    if (across > 54) continue;
    const double radius2 = (across * across + along * along) / (chamber * chamber);
    rise.dome = 8 * std::max(0.0, 1 - radius2);
    const double corner = std::clamp((across - 6) / (port_half - 6), 0.0, 1.0);
    const double slope = 4 * std::clamp((along - 32) / (middle - 32), 0.0, 1.0);
    const double share = fade(across, port_half + wall, port_half + wall + 10);
    rise.port_floor = share * (slope + 5 * corner * corner);
    rise.port_roof = share * (slope - 5 * corner * corner);
    if (across < 8) rise.bearing = std::min(0.0, 7.25 - half_chord(14, along - shaft_offset));
  }
  const double round = (level::port_high - level::port_low) / 2;
  const double end =
      fade(std::min(x, length - x), wall, 2 * wall) * fade(std::abs(y - middle), round, round + wall);
  const double sink = end * (round - half_chord(round, y - middle));
  rise.port_floor += sink;
  rise.port_roof -= sink;
  return rise;
}

double lift(double x, double y, double z) noexcept {
  const Storeys rise = storeys_at(x, y);
  const std::array<Rise, 12> rises{{{level::face, 0},
                                    {level::deck, rise.dome},
                                    {level::roof, rise.dome},
                                    {level::port_floor, rise.port_floor},
                                    {level::port_low, rise.port_floor},
                                    {level::port_high, rise.port_roof},
                                    {level::port_roof, rise.port_roof},
                                    {level::oil_floor, 0},
                                    {level::guide_top, 0},
                                    {level::bearing, rise.bearing},
                                    {level::rail, 0},
                                    {level::top, 0}}};
  return risen(z, rises);
}

}  // namespace

/// papers/huang-2001, section 5.5: a cylinder head with 135,429 triangles, 40 kg, 266 by 480 by 157, walls of
/// 9 to 10 mm, looked through for sections deeper than 8.5 mm. Theirs is not public. This one stands in for
/// it: four cylinders in a row along x, four valves each, lengths in millimetres, 5.78e6 mm3, which is 41.6
/// kg of iron at 7.2 g/cm3, and 135,430 triangles, for a closed mesh has no odd number of them: the spacing
/// and the corners of the cover's screws are chosen for that.
///
/// Depth: walls and decks of 9 give 4.5, where a wall stands on another 5.6, on a deck through which a wall
/// runs at most 6.75 (the ball through four inner edges a wall's thickness apart: sqrt(3)/2 * 9 = 7.8 would
/// need three walls that all run through, and there is none). Between valve bores the ball is bounded by two
/// bores and the injector's: 6.64; above the bores, where the ports end, 6.9. The heavy section has 9.5.
Mesh cylinder_head() {
  return build_layers(recipe_steps(),
                      {.spacing = 5.392, .layer = 6, .size = {length, width, height}, .lift = lift});
}

}  // namespace cdfr
