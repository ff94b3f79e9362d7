// Walls that meet: extruded cross-sections with fillets.
//
// A fillet of radius f between walls of half width a has its centre a + f from the middle of each wall. Inner
// parallels keep the centres: at depth t fillets have the radius f + t. Once t exceeds a the walls are gone,
// and what is left round the junction lies between those arcs, and outer faces that have no fillet.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "analysis/deep_levels.h"
#include "analysis/shapes.h"
#include "analysis/solids.h"

namespace cdfr::test {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double half = 1, fillet = 1.5, reach = 8, height = 6;

Point2 towards(double angle, double way) { return {way * std::cos(angle), way * std::sin(angle)}; }

/// Walls from the origin that far in these directions, rising angles. Between neighbours there is a fillet,
/// or nothing where they go straight on, or an outer corner with that radius.
RoundedPolygon walls(const std::vector<double>& directions, double outer) {
  RoundedPolygon polygon;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const double angle = directions[i];
    const Point2 end = towards(angle, reach), across = towards(angle + pi / 2, half);
    polygon.corners.push_back({end.x - across.x, end.y - across.y});
    polygon.corners.push_back({end.x + across.x, end.y + across.y});
    polygon.radii.insert(polygon.radii.end(), 2, 0.0);
    const double next = i + 1 < directions.size() ? directions[i + 1] : directions[0] + 2 * pi;
    const double gap = next - angle;
    if (std::fabs(gap - pi) < 1e-9) continue;
    polygon.corners.push_back(towards(angle + gap / 2, half / std::sin(gap / 2)));
    polygon.radii.push_back(gap < pi ? fillet : outer);
  }
  return polygon;
}

/// The fillet at depth t, cut off at both ends: there its centre is `from` and `to` away from a line that the
/// arc's end tangent runs along, a wall's middle or an outer face's parallel.
Arc cut_fillet(Arc arc, double t, double from, double to) {
  arc.radius += t;
  const double first = std::acos(from / arc.radius), last = std::acos(to / arc.radius);
  return {arc.centre, arc.radius, arc.from - first, arc.sweep + first + last};
}

std::vector<Arc> fillets_of(const RoundedPolygon& polygon) {
  std::vector<Arc> found;
  for (const Arc& arc : polygon.profile().arcs) {
    if (arc.sweep < 0) found.push_back(arc);
  }
  return found;
}

/// `core` is {depth > t} of the cross-section for t above the walls' half width.
Shape junction(const char* name, const RoundedPolygon& polygon, double chord,
               const std::function<Profile(double)>& core, double wall, const InscribedBall& ball,
               std::vector<double> depths) {
  const Extrusion solid{polygon.profile(), height};
  Shape shape{name,         solid.mesh(chord),
              chord,        solid.volume(),
              solid.area(), [solid](const Vec3& p) { return solid.depth(p); },
              {ball},       {},
              {},           {}};
  std::erase_if(depths, [&](double t) { return t + chord >= ball.radius; });
  shape.levels = deep_levels(
      [=](double t) -> std::vector<double> {
        const Profile profile = t < wall ? polygon.inset(t).profile() : core(t);
        return {profile.area() * (height - 2 * t)};
      },
      depths, chord);
  return shape;
}

Place place(Point2 p, Point2 normal, double sphere, double ray) {
  return {{p.x, p.y, height / 2}, {normal.x, normal.y, 0}, sphere, ray};
}

/// The middles of the end walls' faces, 6 from the junction.
void add_wall_places(Shape& shape, const std::vector<double>& directions) {
  for (const double angle : directions) {
    for (const double side : {-1.0, 1.0}) {
      const Point2 along = towards(angle, 6), across = towards(angle + pi / 2, side);
      shape.places.push_back(
          place({along.x + half * across.x, along.y + half * across.y}, across, 2 * half, 2 * half));
    }
  }
}

/// Walls in equal gaps below a half turn: the ball touches all fillets.
Shape star(const char* name, const std::vector<double>& directions, double chord) {
  const RoundedPolygon polygon = walls(directions, 0);
  const double gap = directions[1] - directions[0];
  const double radius = (half + fillet) / std::sin(gap / 2) - fillet;
  const auto core = [polygon](double t) {
    Profile profile;
    for (const Arc& arc : fillets_of(polygon))
      profile.arcs.push_back(cut_fillet(arc, t, half + fillet, half + fillet));
    return profile;
  };
  Shape shape = junction(name, polygon, chord, core, half, {{0, 0, height / 2}, radius, false},
                         {0.5, half + 0.1, (half + radius) / 2});
  add_wall_places(shape, directions);
  // In a fillet's middle the ray goes through the centre, to the opposite fillet or down the opposite wall.
  const double angle = directions[0] + gap / 2;
  const bool even = directions.size() % 2 == 0;
  shape.places.push_back(
      place(towards(angle, radius), towards(angle, 1), 2 * radius, radius + (even ? radius : reach)));
  return shape;
}

/// Two walls of those thicknesses on the lines x = 0 and y = 0, rounded by `outer` where these meet. The ball
/// touches both lines and the fillet: with p and q the coordinates of the fillet's centre, (p - r)^2 + (q -
/// r)^2 = (f + r)^2.
Shape bend(const char* name, double x_wall, double y_wall, double f, double outer, double chord) {
  const RoundedPolygon polygon{
      {{0, 0}, {reach, 0}, {reach, y_wall}, {x_wall, y_wall}, {x_wall, reach}, {0, reach}},
      {outer, 0, 0, f, 0, 0}};
  const double p = x_wall + f, q = y_wall + f, sum = p + q + f;
  const double r = sum - std::sqrt(sum * sum - (p * p + q * q - f * f));
  const auto core = [=](double t) {
    Profile profile;
    profile.arcs.push_back(cut_fillet(fillets_of(polygon)[0], t, q - t, p - t));
    profile.arcs.push_back({{t, t}, 0, 0, 0});
    return profile;
  };
  const double wall = std::max(x_wall, y_wall) / 2;
  Shape shape = junction(name, polygon, chord, core, wall, {{r, r, height / 2}, r, false},
                         {std::min(x_wall, y_wall) / 4, wall + 0.06, (wall + r) / 2});
  shape.places = {place({6.5, 0}, {0, -1}, y_wall, y_wall), place({6.5, y_wall}, {0, 1}, y_wall, y_wall),
                  place({0, 6.5}, {-1, 0}, x_wall, x_wall), place({x_wall, 6.5}, {1, 0}, x_wall, x_wall),
                  place({r, 0}, {0, -1}, 2 * r, reach),     place({0, r}, {-1, 0}, 2 * r, reach)};
  return shape;
}

}  // namespace

Shape l_junction(double chord) { return bend("L junction", 2 * half, 2 * half, fillet, 0.75, chord); }
Shape filleted_plates(double chord) { return bend("filleted plates", 2, 3, 2, 0, chord); }
Shape x_junction(double chord) { return star("X junction", {0, pi / 2, pi, 3 * pi / 2}, chord); }
Shape y_junction(double chord) {
  return star("Y junction", {pi / 2, pi / 2 + 2 * pi / 3, pi / 2 + 4 * pi / 3}, chord);
}

// The ball touches the flange's outer face y = a and both fillets, whose centres are (+-A, -A), A = a + f.
// Its centre (0, c) has A^2 + (c + A)^2 = (r + f)^2 with r = a - c, so c = -A / 4.
Shape t_junction(double chord) {
  const std::vector<double> directions{0, pi, 3 * pi / 2};
  const RoundedPolygon polygon = walls(directions, 0);
  const double centres = half + fillet, radius = half + centres / 4;
  const auto core = [=](double t) {
    const std::vector<Arc> both = fillets_of(polygon);
    Profile profile;
    profile.arcs = {cut_fillet(both[0], t, centres + half - t, centres),
                    cut_fillet(both[1], t, centres, centres + half - t)};
    return profile;
  };
  Shape shape =
      junction("T junction", polygon, chord, core, half, {{0, -centres / 4, height / 2}, radius, false},
               {0.5, half + 0.1, (half + radius) / 2});
  add_wall_places(shape, directions);
  shape.places.push_back(place({0, half}, {0, 1}, 2 * radius, half + reach));
  return shape;
}

}  // namespace cdfr::test
