#include "oracle/random_solids.h"

#include "oracle/vectors.h"
#include "support/joined.h"
#include "support/meshes.h"

namespace cdfr::oracle {
namespace {

/// By a turn about a random axis: v + 2 w (u x v) + 2 u x (u x v) for the unit quaternion (w, u).
Mesh turned(Mesh mesh, Random& random) {
  double w = random.between(-1, 1);
  Vec3 u{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
  const double size = std::sqrt(w * w + dot(u, u));
  w /= size, u = times(1 / size, u);
  for (Vec3& v : mesh.vertices) {
    const Vec3 once = cross(u, v);
    v = plus(plus(v, 2 * w, once), 2, cross(u, once));
  }
  return mesh;
}

Mesh body(Random& random) {
  if (random.below(3) == 0) return test::sphere_mesh(2, random.between(0.3, 1));
  const Vec3 half{random.between(0.1, 1), random.between(0.1, 1), random.between(0.1, 1)};
  return turned(test::box_mesh({times(-1, half), half}), random);
}

}  // namespace

Mesh random_solid(Random& random) {
  const std::uint64_t bodies = 2 + random.below(5);
  Mesh solid;
  for (std::uint64_t i = 0; i < bodies; ++i) {
    const Vec3 place{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
    solid = test::joined(std::move(solid), test::moved(body(random), place));
  }
  return solid;
}

}  // namespace cdfr::oracle
