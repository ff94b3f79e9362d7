#include "soak/side_oracle.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace cdfr::soak {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Flat = Kernel::Point_2;
using Exact = CGAL::Simple_cartesian<CGAL::Exact_rational>;
using Corners = std::array<Vec3, 3>;

Point point(const Vec3& v) { return {v.x, v.y, v.z}; }
Flat seen_from_above(const Vec3& v) { return {v.x, v.y}; }

bool has_area(const Corners& t) { return !CGAL::collinear(point(t[0]), point(t[1]), point(t[2])); }

Exact::Point_3 exact(const Vec3& v) { return {v.x, v.y, v.z}; }

std::vector<Corners> proper_triangles(const Mesh& mesh) {
  std::vector<Corners> triangles;
  for (const Triangle& t : mesh.triangles) {
    const Corners corners{mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]};
    if (has_area(corners)) triangles.push_back(corners);
  }
  return triangles;
}

std::vector<Box> boxes_of(const std::vector<Corners>& triangles) {
  std::vector<Box> boxes;
  for (const auto& [a, b, c] : triangles) {
    boxes.push_back({{std::min({a.x, b.x, c.x}), std::min({a.y, b.y, c.y}), std::min({a.z, b.z, c.z})},
                     {std::max({a.x, b.x, c.x}), std::max({a.y, b.y, c.y}), std::max({a.z, b.z, c.z})}});
  }
  return boxes;
}

/// 1 if p' is to the left of the line from a to b as seen from above, else -1; 0 if a is above b. The
/// determinant grows by (bx - ax) e^2 - (by - ay) e from p to p'.
int side_from_above(const Vec3& a, const Vec3& b, const Vec3& p) {
  const CGAL::Orientation turn =
      CGAL::orientation(seen_from_above(a), seen_from_above(b), seen_from_above(p));
  if (turn != CGAL::COLLINEAR) return turn == CGAL::LEFT_TURN ? 1 : -1;
  if (a.y != b.y) return b.y < a.y ? 1 : -1;
  return a.x == b.x ? 0 : (b.x > a.x ? 1 : -1);
}

/// 1 if the vertical line through p' meets the triangle from below its front, -1 from above, 0 if not at all.
int met_by_vertical(const Corners& t, const Vec3& p) {
  const int side = side_from_above(t[0], t[1], p);
  if (side == 0 || side_from_above(t[1], t[2], p) != side) return 0;
  return side_from_above(t[2], t[0], p) == side ? side : 0;
}

/// Precondition: p is in the triangle's plane.
bool covers(const Corners& t, const Vec3& p) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Point a = point(t[k]), b = point(t[(k + 1) % 3]), c = point(t[(k + 2) % 3]);
    if (CGAL::coplanar_orientation(a, b, c, point(p)) == CGAL::NEGATIVE) return false;
  }
  return true;
}

/// Where the vertical line through (x, y) meets the triangle's plane. Precondition: met_by_vertical.
Exact::FT height(const Corners& t, double x, double y) {
  const Exact::Plane_3 plane(exact(t[0]), exact(t[1]), exact(t[2]));
  return -(plane.a() * x + plane.b() * y + plane.d()) / plane.c();
}

}  // namespace

SideOracle::SideOracle(const Mesh& mesh) : triangles_(proper_triangles(mesh)), tree_(boxes_of(triangles_)) {}

std::optional<int> SideOracle::winding(Vec3 p) const {
  const Vec3 top{p.x, p.y, std::numeric_limits<double>::infinity()};
  int count = 0;
  bool on_surface = false;
  tree_.over({p, top}, [&](std::uint32_t number) {
    const Corners& t = triangles_[number];
    if (tree_.box(number).lo.z > p.z) {
      count += met_by_vertical(t, p);
      return true;
    }
    const CGAL::Orientation above = CGAL::orientation(point(t[0]), point(t[1]), point(t[2]), point(p));
    if (above == CGAL::COPLANAR) {
      on_surface = covers(t, p);  // if not, the line misses it too
      return !on_surface;
    }
    const int met = met_by_vertical(t, p);
    if (met != 0 && (above == CGAL::POSITIVE) != (met > 0)) count += met;
    return true;
  });
  if (on_surface) return std::nullopt;
  return count;
}

std::optional<int> SideOracle::winding_in_front(const Corners& t, double x, double y) const {
  const double infinity = std::numeric_limits<double>::infinity();
  const Vec3 p{x, y, 0};
  const int own = met_by_vertical(t, p);
  if (own == 0) return std::nullopt;
  const Exact::FT level = height(t, x, y);
  int above = 0;
  bool alone = true;
  tree_.over({{x, y, -infinity}, {x, y, infinity}}, [&](std::uint32_t number) {
    const Corners& other = triangles_[number];
    const int met = other == t ? 0 : met_by_vertical(other, p);
    if (met == 0) return true;
    const CGAL::Comparison_result higher = CGAL::compare(height(other, x, y), level);
    alone = higher != CGAL::EQUAL;
    if (higher == CGAL::LARGER) above += met;
    return alone;
  });
  if (!alone) return std::nullopt;
  return own > 0 ? above : above + own;
}

bool SideOracle::within(Vec3 p, double reach) const {
  const double margin = reach * 1.001 + std::numeric_limits<double>::denorm_min();
  const auto moved = [](const Vec3& v, double by) { return Vec3{v.x + by, v.y + by, v.z + by}; };
  const Exact::FT limit = Exact::FT(reach) * Exact::FT(reach);
  // A sum that rounds to the coordinate itself would lose the margin.
  const double infinity = std::numeric_limits<double>::infinity();
  const auto wider = [&](Vec3 v, double to) {
    return Vec3{std::nextafter(v.x, to), std::nextafter(v.y, to), std::nextafter(v.z, to)};
  };
  bool found = false;
  tree_.over({wider(moved(p, -margin), -infinity), wider(moved(p, margin), infinity)},
             [&](std::uint32_t number) {
               const auto& [a, b, c] = triangles_[number];
               const Exact::Triangle_3 triangle(exact(a), exact(b), exact(c));
               found = CGAL::squared_distance(exact(p), triangle) <= limit;
               return !found;
             });
  return found;
}

}  // namespace cdfr::soak
