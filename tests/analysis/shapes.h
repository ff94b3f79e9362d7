/// Solids whose thickness and heavy sections have closed forms, with meshes of them at a chosen fineness.
///
/// What the mesh may answer: its signed distances differ from the solid's by at most `error` (see solids.h),
/// so
/// - the largest ball in the mesh has the solid's radius +- error, and its centre is where the solid is at
/// least that
///   deep less 2 error;
/// - {depth > t} in the mesh lies between {depth > t + error} and {depth > t - error} of the solid;
/// - r - depth(p - r n) grows with r, since depths change no faster than places, so the largest r that keeps
/// it within D
///   lies between those for D - error and D + error in the solid;
/// - volumes differ by at most area * error, to first order.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "cdfr/mesh/mesh.h"

namespace cdfr::test {

/// A largest ball, or a local one.
struct InscribedBall {
  Vec3 centre;
  double radius = 0;
  bool only = false;  ///< no other centre will do; else there is a line or a sheet of them
};

/// One component of {depth > t}: its volume in the solid, and the range that the mesh's lies in.
struct Region {
  double volume = 0, low = 0, high = 0;
};

/// {depth > depth}, the components by falling ball.
struct DeepLevel {
  double depth = 0;
  std::vector<Region> regions;
};

/// A point of the solid's surface with its outward normal, and the thickness there: diameter of the ball that
/// touches here, and length of the ray.
struct Place {
  Vec3 point, normal;
  double sphere = 0, ray = 0;
};

/// The narrowest place between two local balls: the largest ball that passes is centred there.
struct Neck {
  Vec3 centre;
  double radius = 0;
};

struct Shape {
  std::string name;
  Mesh mesh;
  double error = 0;  ///< 0: the mesh is the solid
  double volume = 0, area = 0;
  std::function<double(const Vec3&)> depth;  ///< in the solid; outside only the sign is told
  std::vector<InscribedBall> balls;          ///< by falling radius, no two joined without a neck
  std::vector<Neck> necks;
  std::vector<DeepLevel> levels;
  std::vector<Place> places;
};

Shape plate(double chord);            ///< 12 x 10 x 2
Shape box(double chord);              ///< 3 x 4 x 5
Shape cube(double chord);             ///< 4 x 4 x 4: one largest ball
Shape stepped_plate(double chord);    ///< walls of 2 and 5, end to end, on one plane
Shape corner(double chord);           ///< three walls at right angles and a slanted one: a ball in a corner
Shape l_junction(double chord);       ///< walls of 2 with a fillet of 1.5, rounded outside by 0.75
Shape t_junction(double chord);       ///< walls of 2 with fillets of 1.5
Shape x_junction(double chord);       ///< walls of 2 with fillets of 1.5
Shape y_junction(double chord);       ///< walls of 2 at 120 degrees with fillets of 1.5
Shape filleted_plates(double chord);  ///< walls of 2 and 3 at right angles with a fillet of 2, sharp outside
Shape ball(double chord);             ///< of radius 3
Shape cone(double chord);             ///< radius 3, height 4
Shape tube(double chord);             ///< radii 4 and 6, length 10
Shape torus(double chord);            ///< a ring of radius 1.5 at 4
Shape dumbbell(double chord);         ///< balls of radius 3 and 2, a concave neck of radius 0.75

/// All of them.
std::vector<Shape> shapes(double chord);

}  // namespace cdfr::test
