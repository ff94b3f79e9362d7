/// A small painted mesh with everything that a file can hold.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "cdfr/export/painted.h"

namespace cdfr {

/// The view borrows from the vectors, so it is made anew by painted().
struct PaintedCase {
  static constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  Mesh mesh{{{10.1, 0, 0}, {11, -0.0, 1e-17}, {10, 1 / 3.0, 0}, {10, 0, 2.5}},
            {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}},
            {7, 7, 0, 7},
            {}};
  std::vector<double> thickness{1 / 3.0, nan, 2, 19};
  std::vector<double> error{1e-9, infinity, -infinity, nan};
  std::vector<double> depth{0.1, 0.2, nan, 1e300};
  std::string painted_array = "thickness";

  PaintedMesh painted() const {
    PaintedMesh made{mesh.view()};
    made.arrays = {{"thickness", ArrayPlace::vertex, thickness},
                   {"error", ArrayPlace::vertex, error},
                   {"depth_of_face", ArrayPlace::face, depth}};
    made.painted = painted_array;
    made.least = 1;
    made.greatest = 11;
    made.unit = "mm";
    made.balls = {{{10.25, 0.1, 0.5}, 0.125}, {{10.5, 0.2, 0.25}, 1e-3}};
    made.labels = {{{10.25, 0.1, 0.5}, "1: 17.0 mm +- 0.1"}, {{10, 0, 2.5}, "two\nlines \xc2\xb1 & <b>"}};
    made.notes = {"sha256: 00ff", "two\nlines"};
    return made;
  }
};

}  // namespace cdfr
