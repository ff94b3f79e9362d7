#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "parts/layers.h"
#include "parts/made_parts.h"
#include "parts/rise.h"

namespace cdfr {
namespace {

constexpr double length = 600, width = 300, height = 250;
constexpr double wall = 7.5;
constexpr double middle = 150;                          ///< the cylinders' row in y
constexpr double side = 72, other_side = width - side;  ///< outer faces of the long walls
constexpr std::array<double, 4> cylinders{87, 229, 371, 513};
constexpr std::array<double, 5> bearings{wall / 2, 158, 300, 442, length - wall / 2};
constexpr std::array<double, 5> bolt_rows{30, 158, 300, 442, 570};

/// Heights of the storeys, from the face on the oil pan up.
namespace level {
constexpr double pan = 0, rail = 7.5, arch = 20, door_low = 28, door_high = 72, floor = 92, jacket = 99.5,
                 core_low = 150, core_high = 182, block_top = 195, flange_top = 220, deck = 242.5,
                 top = height;
}  // namespace level

constexpr double bore = 40, bolt = 5.5, column = 13, water = 4;
constexpr double bolt_offset = 50, water_offset = 59;
constexpr double shaft = 34, arch_half = 27.5;  ///< main bearings: round above `arch`, upright below
constexpr double core = 16, core_half = 15.5;   ///< core holes in the long walls

/// Crankcase and water jacket under a deck, with a rail for the oil pan and a flange for the gearbox.
void add_shell(Recipe& recipe) {
  const Outline room = rectangle(wall, side + wall, length - wall, other_side - wall);
  recipe.fill(rectangle(0, side - 14, length, other_side + 14), level::pan, level::rail);
  recipe.fill(rounded(0, side, length, other_side, 12, 4), level::pan, level::top);
  recipe.fill(rectangle(length - wall, 0, length, width), level::door_low, level::flange_top);
  recipe.empty(room, level::pan, level::floor);
  recipe.empty(room, level::jacket, level::deck);
}

void add_crankcase(Recipe& recipe) {
  for (const double x : bearings) {
    recipe.fill(rectangle(x - wall / 2, side, x + wall / 2, other_side), level::pan, level::floor);
    for (double y = middle - arch_half; y < middle + arch_half; y += 5) {  // lines across the round
      recipe.empty(rectangle(x - wall / 2, y, x + wall / 2, y + 5), level::pan, level::arch);
    }
  }
  for (const double x : cylinders) {
    recipe.empty(rectangle(x - 45, side, x + 45, side + wall), level::door_low, level::door_high);
    recipe.empty(rectangle(x - 45, other_side - wall, x + 45, other_side), level::door_low, level::door_high);
  }
}

void add_cylinders(Recipe& recipe) {
  for (const double x : cylinders) {
    recipe.fill(disc(x, middle, bore + wall, 72), level::floor, level::top);
    recipe.empty(disc(x, middle, bore, 64), level::floor, level::top);
    for (const double y : {middle - water_offset, middle + water_offset}) {
      recipe.empty(disc(x, y, water, 12), level::deck, level::top);
    }
    recipe.empty(rectangle(x - core_half, side, x + core_half, side + wall), level::core_low,
                 level::core_high);
    recipe.empty(rectangle(x - core_half, other_side - wall, x + core_half, other_side), level::core_low,
                 level::core_high);
  }
}

/// Columns with a bore through floor and deck, for the head bolts.
void add_bolts(Recipe& recipe) {
  for (const double x : bolt_rows) {
    for (const double y : {middle - bolt_offset, middle + bolt_offset}) {
      recipe.fill(disc(x, y, column, 24), level::jacket, level::deck);
      recipe.empty(disc(x, y, bolt, 16), level::floor, level::top);
    }
  }
}

/// The one heavy section, in the water jacket between the middle cylinders: a block 22 thick, 32 long and 45
/// high, held by webs to two columns. Both sides, x = 300 +- 11, are free and whole, so no ball in it is
/// larger than 11, and one of 11 fits wherever the middle plane is as far from top, bottom and ends: from y =
/// 145 to 155 and from z = 161 to 184 (in y a little more, as in the cylinder head).
void add_heavy_section(Recipe& recipe) {
  recipe.fill(rectangle(300 - wall / 2, middle - 38, 300 + wall / 2, middle + 38), level::core_low,
              level::block_top);
  recipe.fill(rectangle(289, middle - 16, 311, middle + 16), level::core_low, level::block_top);
}

std::vector<Step> recipe_steps() {
  Recipe recipe;
  add_shell(recipe);
  add_crankcase(recipe);
  add_heavy_section(recipe);
  add_cylinders(recipe);
  add_bolts(recipe);
  return std::move(recipe.steps);
}

/// How far arches and core holes rise over a point of the plan.
double arch_at(double x, double y) {
  double near = length;
  for (const double bearing : bearings) near = std::min(near, std::abs(x - bearing));
  return fade(near, wall / 2, wall / 2 + 6) * std::max(0.0, half_chord(shaft, y - middle) - level::arch);
}

double core_at(double x, double y) {
  double near = length;
  for (const double cylinder : cylinders) near = std::min(near, std::abs(x - cylinder));
  const double depth = std::min(y - side, other_side - y);
  return fade(depth, wall, 2 * wall) * fade(near, core, core + wall) * (core - half_chord(core, near));
}

double lift(double x, double y, double z) noexcept {
  const double core_rise = core_at(x, y);
  const std::array<Rise, 8> rises{{{level::pan, 0},
                                   {level::arch, arch_at(x, y)},
                                   {level::floor, 0},
                                   {level::jacket, 0},
                                   {level::core_low, core_rise},
                                   {level::core_high, -core_rise},
                                   {level::flange_top, 0},
                                   {level::top, 0}}};
  return risen(z, rises);
}

}  // namespace

/// papers/huang-2001-report, section 6: an engine of more than 130,000 triangles, 40 kg, 600 by 300 by 250
/// mm, nowhere thicker than 11 mm from the surface, looked through for sections deeper than 10 mm. Theirs is
/// not public. This one stands in for it: the block of four cylinders in a row along x, 137,924 triangles and
/// 5.81e6 mm3, which is 41.8 kg of iron at 7.2 g/cm3.
///
/// Depth: walls and decks of 7.5 give 3.75, and their joints, liners and columns less than 6 (a search in
/// tests/parts). The heavy section has 11.
Mesh engine() {
  return build_layers(recipe_steps(),
                      {.spacing = 5.2, .layer = 6, .size = {length, width, height}, .lift = lift});
}

}  // namespace cdfr
