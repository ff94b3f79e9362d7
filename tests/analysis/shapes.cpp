#include "analysis/shapes.h"

namespace cdfr::test {

std::vector<Shape> shapes(double chord) {
  std::vector<Shape> all;
  for (const auto make : {plate, box, cube, stepped_plate, corner, l_junction, t_junction, x_junction,
                          y_junction, filleted_plates, ball, cone, tube, torus, dumbbell}) {
    all.push_back(make(chord));
  }
  return all;
}

}  // namespace cdfr::test
