// Shapes of plane faces: their meshes are exact.
#include <algorithm>
#include <cmath>

#include "analysis/deep_levels.h"
#include "analysis/shapes.h"
#include "analysis/solids.h"

namespace cdfr::test {
namespace {

Profile rectangle(double x, double y) {
  return RoundedPolygon{{{0, 0}, {x, 0}, {x, y}, {0, y}}, {0, 0, 0, 0}}.profile();
}

Shape block(const char* name, const Vec3& size, const std::vector<double>& depths) {
  const Extrusion solid{rectangle(size.x, size.y), size.z};
  Shape shape{name,
              solid.mesh(0),
              0,
              solid.volume(),
              solid.area(),
              [solid](const Vec3& p) { return solid.depth(p); },
              {},
              {},
              {},
              {}};
  const double least = std::min({size.x, size.y, size.z});
  shape.balls = {{{size.x / 2, size.y / 2, size.z / 2}, least / 2, size.x == size.y && size.y == size.z}};
  shape.levels = deep_levels(
      [size](double t) -> std::vector<double> {
        return {(size.x - 2 * t) * (size.y - 2 * t) * (size.z - 2 * t)};
      },
      depths, 0);
  shape.places = {{{size.x / 2, size.y / 2, 0}, {0, 0, -1}, least, size.z},
                  {{size.x / 2, size.y / 2, size.z}, {0, 0, 1}, least, size.z},
                  {{size.x, size.y / 2, size.z / 2}, {1, 0, 0}, least, size.x},
                  {{size.x / 2, 0, size.z / 2}, {0, -1, 0}, least, size.y}};
  return shape;
}

}  // namespace

Shape plate(double) { return block("plate", {12, 10, 2}, {0.25, 0.75}); }
Shape box(double) { return block("box", {3, 4, 5}, {0.5, 1.25}); }
Shape cube(double) { return block("cube", {4, 4, 4}, {0.5, 1, 1.75}); }

namespace {

constexpr double thin = 2, thick = 5, thin_length = 8, whole_length = 20, width = 9;

/// The walls end to end, less a margin of t: the thin one is there while it is thicker than 2 t. Beyond that
/// the inner corner's disc of radius t bounds the thick one, down to where it meets the floor's parallel.
Profile stepped(double t) {
  if (2 * t < thin) {
    return RoundedPolygon{{{0, 0},
                           {whole_length, 0},
                           {whole_length, thick},
                           {thin_length, thick},
                           {thin_length, thin},
                           {0, thin}},
                          {0, 0, 0, 0, 0, 0}}
        .inset(t)
        .profile();
  }
  Profile profile;
  for (const Point2 corner : {Point2{whole_length - t, t}, Point2{whole_length - t, thick - t},
                              Point2{thin_length + t, thick - t}}) {
    profile.arcs.push_back({corner, 0, 0, 0});
  }
  profile.arcs.push_back({{thin_length, thin}, t, 0, -std::asin((thin - t) / t)});
  return profile;
}

}  // namespace

Shape stepped_plate(double) {
  const Extrusion solid{stepped(0), width};
  Shape shape{"stepped plate",
              solid.mesh(0),
              0,
              solid.volume(),
              solid.area(),
              [solid](const Vec3& p) { return solid.depth(p); },
              {},
              {},
              {},
              {}};
  shape.balls = {{{14, thick / 2, width / 2}, thick / 2, false}};
  shape.levels =
      deep_levels([](double t) -> std::vector<double> { return {stepped(t).area() * (width - 2 * t)}; },
                  {0.5, 0.875, 1.25, 1.75}, 0);
  const double middle = width / 2;
  shape.places = {
      {{4, 0, middle}, {0, -1, 0}, thin, thin},
      {{4, thin, middle}, {0, 1, 0}, thin, thin},
      {{14, 0, middle}, {0, -1, 0}, thick, thick},
      {{14, thick, middle}, {0, 1, 0}, thick, thick},
      // On the riser: a ball there meets the upper face first, whose edge is as near as the inner corner.
      {{thin_length, (thin + thick) / 2, middle}, {-1, 0, 0}, thick - thin, whole_length - thin_length}};
  return shape;
}

namespace {

/// x, y, z >= 0 and x + y + z <= reach.
constexpr double reach = 6;

double corner_depth(const Vec3& p) {
  return std::min({p.x, p.y, p.z, (reach - p.x - p.y - p.z) / std::sqrt(3.0)});
}

}  // namespace

// A ball in a corner: the inscribed ball of three walls at right angles and one across. Its centre is as far
// from x = 0 as from the slanted wall, r = (s - 3 r) / sqrt(3); {depth > t} is the whole in small, shrunk
// about that centre. A ball that touches z = 0 at (x, y) is centred above it, so it has the radius min(x, y,
// r) with r = (s - x - y - r) / sqrt(3).
Shape corner(double) {
  Shape shape;
  shape.name = "corner";
  shape.mesh.vertices = {{0, 0, 0}, {reach, 0, 0}, {0, reach, 0}, {0, 0, reach}};
  shape.mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  const double volume = reach * reach * reach / 6, r = reach / (3 + std::sqrt(3.0));
  shape.volume = volume;
  shape.area = 3 * reach * reach / 2 + std::sqrt(3.0) / 2 * reach * reach;
  shape.depth = corner_depth;
  shape.balls = {{{r, r, r}, r, true}};
  shape.levels =
      deep_levels([volume, r](double t) -> std::vector<double> { return {volume * std::pow(1 - t / r, 3)}; },
                  {0.25, 0.75, 1.125}, 0);
  const auto on_floor = [](double x, double y) {
    const double radius = std::min({x, y, (reach - x - y) / (1 + std::sqrt(3.0))});
    return Place{{x, y, 0}, {0, 0, -1}, 2 * radius, reach - x - y};
  };
  shape.places = {on_floor(r, r), on_floor(0.5, 2), on_floor(2, 0.25), on_floor(2, 3)};
  return shape;
}

}  // namespace cdfr::test
