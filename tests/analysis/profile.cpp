#include "analysis/profile.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

namespace cdfr::test {
namespace {

constexpr double pi = std::numbers::pi;

double distance(Point2 a, Point2 b) { return std::hypot(a.x - b.x, a.y - b.y); }

/// The sides as pairs of ends, and the arcs between them.
template <class OnSide, class OnArc>
void along(const Profile& profile, OnSide on_side, OnArc on_arc) {
  for (std::size_t i = 0; i < profile.arcs.size(); ++i) {
    on_arc(profile.arcs[i]);
    on_side(profile.arcs[i].at(1), profile.arcs[(i + 1) % profile.arcs.size()].at(0));
  }
}

/// The antiderivatives of cos^n at the arc's end less at its beginning.
struct CosineIntegrals {
  explicit CosineIntegrals(const Arc& arc) {
    const double a = arc.from, b = arc.from + arc.sweep, sa = std::sin(a), sb = std::sin(b);
    first = sb - sa;
    second = (b - a) / 2 + (std::sin(2 * b) - std::sin(2 * a)) / 4;
    third = (sb - sb * sb * sb / 3) - (sa - sa * sa * sa / 3);
  }
  double first, second, third;
};

/// Whether the arc's centre sees q within its sweep, up to rounding.
bool faces(const Arc& arc, Point2 q) {
  const double way = arc.sweep < 0 ? -1 : 1;
  double turned = std::fmod(way * (std::atan2(q.y - arc.centre.y, q.x - arc.centre.x) - arc.from), 2 * pi);
  if (turned < -1e-12) turned += 2 * pi;
  return turned <= way * arc.sweep + 1e-12 || turned >= 2 * pi - 1e-12;
}

}  // namespace

Point2 Arc::at(double share) const {
  const double angle = from + share * sweep;
  return {centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)};
}

// Green: the area is the integral of x dy along the curve, its moment that of x^2 / 2 dy.
double Profile::area() const {
  double sum = 0;
  along(
      *this, [&](Point2 p, Point2 q) { sum += (p.x + q.x) / 2 * (q.y - p.y); },
      [&](const Arc& arc) {
        const CosineIntegrals cosine(arc);
        sum += arc.radius * (arc.centre.x * cosine.first + arc.radius * cosine.second);
      });
  return sum;
}

double Profile::moment() const {
  double sum = 0;
  along(
      *this, [&](Point2 p, Point2 q) { sum += (p.x * p.x + p.x * q.x + q.x * q.x) / 6 * (q.y - p.y); },
      [&](const Arc& arc) {
        const CosineIntegrals cosine(arc);
        const double x = arc.centre.x, r = arc.radius;
        sum += r / 2 * (x * x * cosine.first + 2 * x * r * cosine.second + r * r * cosine.third);
      });
  return sum;
}

double Profile::length() const {
  double sum = 0;
  along(
      *this, [&](Point2 p, Point2 q) { sum += distance(p, q); },
      [&](const Arc& arc) { sum += arc.radius * std::fabs(arc.sweep); });
  return sum;
}

double Profile::swept_length() const {
  double sum = 0;
  along(
      *this, [&](Point2 p, Point2 q) { sum += (p.x + q.x) / 2 * distance(p, q); },
      [&](const Arc& arc) {
        const double way = arc.sweep < 0 ? -1 : 1;
        sum += arc.radius * way * (arc.centre.x * arc.sweep + arc.radius * CosineIntegrals(arc).first);
      });
  return sum;
}

// The closest side or arc knows the side: left of a side is inside, and so is the centre's side of an arc
// that turns left. An arc counts only for points that its centre sees within the sweep, a side only for those
// beside it.
double Profile::depth(Point2 q, bool axis) const {
  double closest = std::numeric_limits<double>::infinity();
  const auto meet = [&](double signed_depth) {
    if (std::fabs(signed_depth) < std::fabs(closest)) closest = signed_depth;
  };
  along(
      *this,
      [&](Point2 a, Point2 b) {
        const double length = distance(a, b);
        if (length < 1e-12 || (axis && std::fabs(a.x) < 1e-12 && std::fabs(b.x) < 1e-12)) return;
        const Point2 along_side{(b.x - a.x) / length, (b.y - a.y) / length};
        const double foot = (q.x - a.x) * along_side.x + (q.y - a.y) * along_side.y;
        if (foot < -1e-12 || foot > length + 1e-12) return;
        meet(along_side.x * (q.y - a.y) - along_side.y * (q.x - a.x));
      },
      [&](const Arc& arc) {
        const double from_centre = distance(q, arc.centre);
        if (from_centre < 1e-12 || faces(arc, q)) meet((arc.sweep < 0 ? -1 : 1) * (arc.radius - from_centre));
      });
  return closest;
}

// A chord over the angle 2 h is r (1 - cos h) from its arc.
std::vector<Point2> Profile::points(double chord) const {
  std::vector<Point2> found;
  const auto add = [&](Point2 p) {
    if (found.empty() || distance(found.back(), p) > 1e-9) found.push_back(p);
  };
  for (const Arc& arc : arcs) {
    int pieces = 1;
    if (arc.radius > chord) {
      pieces = static_cast<int>(std::ceil(std::fabs(arc.sweep) / (2 * std::acos(1 - chord / arc.radius))));
    }
    if (arc.radius == 0) pieces = 0;
    for (int k = 0; k <= pieces; ++k) add(arc.at(pieces == 0 ? 0 : static_cast<double>(k) / pieces));
  }
  if (distance(found.front(), found.back()) <= 1e-9) found.pop_back();
  return found;
}

namespace {

/// Unit vector from corner i to the next.
Point2 side(const std::vector<Point2>& corners, std::size_t i) {
  const Point2 a = corners[i % corners.size()], b = corners[(i + 1) % corners.size()];
  const double length = distance(a, b);
  return {(b.x - a.x) / length, (b.y - a.y) / length};
}

double turn(Point2 u, Point2 v) { return std::atan2(u.x * v.y - u.y * v.x, u.x * v.x + u.y * v.y); }

}  // namespace

Profile RoundedPolygon::profile() const {
  Profile result;
  const std::size_t n = corners.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Point2 u = side(corners, i + n - 1), v = side(corners, i);
    const double sweep = turn(u, v), way = sweep < 0 ? -1 : 1, r = radii[i];
    const double back = r * std::tan(std::fabs(sweep) / 2);
    // From the end of the side before, its normal leads to the centre: to the left where the polygon turns
    // left.
    const Point2 centre{corners[i].x - back * u.x - way * r * u.y, corners[i].y - back * u.y + way * r * u.x};
    result.arcs.push_back({centre, r, std::atan2(-way * u.x, way * u.y), sweep});
  }
  return result;
}

RoundedPolygon RoundedPolygon::inset(double depth) const {
  RoundedPolygon result;
  const std::size_t n = corners.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Point2 u = side(corners, i + n - 1), v = side(corners, i);
    const double sweep = turn(u, v), along_side = depth * std::tan(sweep / 2);
    // Left of the side before by the depth, and back along it to where the next side's parallel passes.
    result.corners.push_back(
        {corners[i].x - depth * u.y - along_side * u.x, corners[i].y + depth * u.x - along_side * u.y});
    result.radii.push_back(sweep < 0 ? radii[i] + depth : std::max(radii[i] - depth, 0.0));
  }
  return result;
}

}  // namespace cdfr::test
