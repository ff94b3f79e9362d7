/// A program outside the project: it includes one header of each room and measures to a cube.
#include <cstdio>
#include <vector>

#include "cdfr/contour/contour.h"
#include "cdfr/export/write.h"
#include "cdfr/field/field.h"
#include "cdfr/mesh/audit.h"
#include "cdfr/mesh/read.h"
#include "cdfr/parts/part.h"
#include "cdfr/render/splat.h"
#include "cdfr/store/store.h"
#include "cdfr/version.h"

namespace {

cdfr::Mesh unit_cube() {
  cdfr::Mesh cube;
  for (int corner = 0; corner < 8; ++corner) {
    cube.vertices.push_back({double(corner & 1), double(corner >> 1 & 1), double(corner >> 2 & 1)});
  }
  cube.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return cube;
}

bool expect(bool holds, const char* what) {
  std::printf("%s: %s\n", holds ? "ok" : "WRONG", what);
  return holds;
}

}  // namespace

int main() {
  const cdfr::Mesh cube = unit_cube();
  const cdfr::Result<cdfr::Field> field = cdfr::Field::build(cube.view());
  if (!expect(bool(field), "the field of a cube is built")) return 1;
  bool good = expect(field->distance({0.5, 0.5, 0.5}) == -0.5, "its middle is 0.5 deep");
  good &= expect(field->distance({0.5, 0.5, 3}) == 2, "a point above is 2 away");
  good &= expect(field->closest({2, 0.5, 0.5}).point == cdfr::Vec3{1, 0.5, 0.5}, "closest point on a face");
  const auto points = cdfr::contour_points(*field, -0.25, {.tolerance = 0.05});
  good &= expect(points && !points->empty(), "its contour at depth 0.25 has points");
  good &= expect(!cdfr::read_mesh("/nowhere/at all.stl"), "a missing file is an error");
  try {
    cdfr::read_mesh("/nowhere/at all.stl").value();
    good = expect(false, "value() of an error throws");
  } catch (const cdfr::Failure& failure) {
    good &= expect(failure.error().code == cdfr::Code::file_open, "value() of an error throws Failure");
  }
  good &= expect(cdfr::version()[0] == '0', cdfr::version());
  return good ? 0 : 1;
}
