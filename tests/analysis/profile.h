/// Closed curves of straight sides and circular arcs in a plane: cross-sections whose areas, moments, depths
/// and inner parallels have closed forms.
#pragma once

#include <vector>

namespace cdfr::test {

struct Point2 {
  double x = 0, y = 0;
};

/// From angle `from` on through `sweep`, counter-clockwise if that is positive: the inside is then on the
/// centre's side, else (a fillet) on the far side. Of radius 0 it is a sharp corner, whose sweep turns the
/// outward normal.
struct Arc {
  Point2 centre;
  double radius = 0, from = 0, sweep = 0;

  /// 0 is the arc's beginning, 1 its end.
  Point2 at(double share) const;
};

/// Counter-clockwise; straight sides join the end of each arc with the beginning of the next.
struct Profile {
  std::vector<Arc> arcs;

  double area() const;
  double length() const;
  double moment() const;        ///< the integral of x over the area
  double swept_length() const;  ///< the integral of x along the curve

  /// Distance from the curve, positive inside. Sides on the line x = 0 are no wall if `axis`: what revolves
  /// about that line has none there. Precondition: arcs meet at tangents, or a sharp corner lies between.
  double depth(Point2 q, bool axis = false) const;

  /// Points on the curve, so many that no chord is farther than `chord` from its arc.
  std::vector<Point2> points(double chord) const;
};

/// A polygon, counter-clockwise, whose corner i is rounded with radii[i]; no three corners in a row on a
/// line.
struct RoundedPolygon {
  std::vector<Point2> corners;
  std::vector<double> radii;

  Profile profile() const;
  /// What is deeper than `depth`. Where the polygon is convex its radii shrink until corners are sharp,
  /// elsewhere they grow. Precondition: every side keeps a length.
  RoundedPolygon inset(double depth) const;
};

}  // namespace cdfr::test
