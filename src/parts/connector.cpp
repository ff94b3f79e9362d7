#include "parts/made_parts.h"
#include "parts/terraces.h"

namespace cdfr {
namespace {

constexpr double length = 690, width = 200, height = 290, middle = width / 2;  // hundredths
constexpr double flange_low = 40, flange_high = 68, top = 140;

/// A rectangle without its two right corners: a plug fits in one way only.
Outline keyed(double x_low, double y_low, double x_high, double y_high, double cut) {
  return {plan_point(x_low, y_low),         plan_point(x_high - cut, y_low),  plan_point(x_high, y_low + cut),
          plan_point(x_high, y_high - cut), plan_point(x_high - cut, y_high), plan_point(x_low, y_high)};
}

Recipe connector_recipe() {
  Recipe recipe;
  recipe.fill(keyed(140, 52, 540, 148, 20), 0, top);
  recipe.fill(rounded(0, 0, length, width, 95, 2), flange_low, flange_high);
  for (const double x : {60.0, length - 60}) recipe.empty(disc(x, middle, 25, 12), flange_low, flange_high);
  for (const double x : {165.0, 250.0, 450.0}) {  // three contacts: a cavity and the way of its pin
    recipe.empty(rectangle(x, 75, x + 60, 125), 60, top);
    recipe.empty(rectangle(x + 20, 90, x + 40, 110), 0, 60);
  }
  recipe.fill(disc(380, middle, 45, 6), top, height);  // guide post
  return recipe;
}

}  // namespace

/// papers/huang-2001, table 1 and section 5.3; papers/huang-2001-report, section 6: box (6.9, 2.0, 2.9),
/// greatest depth 0.50, 327 triangles, of which a closed mesh cannot have an odd number. Theirs is not
/// public. This one stands in for it: a housing with a flange, contacts and a guide post, 328 triangles,
/// 7.716 in volume and 51.47 in area. Theirs had about 8.3 and 45, judged by the voxels of table 4.
///
/// Triangles (build_terraces): walls of 2 * 6 (body, below and above the flange), 12 (flange), 2 * 12 (its
/// holes), 3 * 4 (cavities), 3 * 4 (pins) and 6 (post) sides make 78, and 5 holes go through:
/// 4 * (78 + 5 - 1).
///
/// Depth: at the heights of the flange, 28, the body, 96 wide, ends in four inner edges along x, which come
/// nearer to each other where its corners are cut. No place between them is farther than 50 from the nearest,
/// for 48^2 + 14^2 = 50^2, and around (380, 100, 54) a ball of 50 touches all four: the cavities are 70 off,
/// the bottom 54. Everywhere else the way out is 48 at most along y, 45 in the post, or 14 along z in the
/// flange.
Mesh connector() { return build_terraces(connector_recipe().steps, 100); }

}  // namespace cdfr
