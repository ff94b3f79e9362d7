#include <algorithm>

#include "soak/families.h"
#include "support/meshes.h"

namespace cdfr::soak {
namespace {

/// From pole to pole in `rings` steps: slivers and a vertex of valence `sides` at each pole.
Mesh globe(std::uint32_t rings, std::uint32_t sides) {
  Mesh mesh;
  const auto at = [&](std::uint32_t ring, std::uint32_t side) { return (ring - 1) * sides + side % sides; };
  for (std::uint32_t ring = 1; ring < rings; ++ring) {
    const OnCircle height = on_circle(ring * 0.5 / rings);
    for (std::uint32_t side = 0; side < sides; ++side) {
      const OnCircle round = on_circle(static_cast<double>(side) / sides);
      add_vertex(mesh, {height.y * round.x, height.y * round.y, height.x});
    }
  }
  const std::uint32_t top = add_vertex(mesh, {0, 0, 1}), bottom = add_vertex(mesh, {0, 0, -1});
  for (std::uint32_t side = 0; side < sides; ++side) {
    mesh.triangles.push_back({top, at(1, side), at(1, side + 1)});
    mesh.triangles.push_back({bottom, at(rings - 1, side + 1), at(rings - 1, side)});
    for (std::uint32_t ring = 1; ring + 1 < rings; ++ring)
      add_quad(mesh, at(ring, side), at(ring + 1, side), at(ring + 1, side + 1), at(ring, side + 1));
  }
  return mesh;
}

/// Every vertex drawn towards the centre by its own factor of at least `least`.
Mesh spiky(Mesh mesh, double least, test::Random& random) {
  for (Vec3& v : mesh.vertices) {
    const double r = random.below(2) == 0 ? random.between(least, 1) : (random.below(2) == 0 ? least : 1);
    v = {r * v.x, r * v.y, r * v.z};
  }
  return mesh;
}

Mesh scaled(Mesh mesh, double factor) {
  for (Vec3& v : mesh.vertices) v = {factor * v.x, factor * v.y, factor * v.z};
  return mesh;
}

}  // namespace

Shape make_sphere(std::uint64_t round, test::Random& random) {
  if (round % 2 == 0) {
    const int level = static_cast<int>(strided(round / 2, 0, 5));
    return {"octahedron, level " + std::to_string(level), test::sphere_mesh(level)};
  }
  const auto rings = static_cast<std::uint32_t>(2 + random.below(60));
  const auto sides = static_cast<std::uint32_t>(3 + random.below(200));
  return {"globe " + std::to_string(rings) + " x " + std::to_string(sides), globe(rings, sides)};
}

/// Thick and thin rings; the hole of the thickest is 1e-3 wide.
Shape make_torus(std::uint64_t round, test::Random& random) {
  const auto rings = static_cast<std::uint32_t>(3 + random.below(80));
  const auto sides = static_cast<std::uint32_t>(3 + random.below(40));
  const double tube = round % 3 == 2 ? 0.999 : tenth(round % 3 * 3 + 1);
  Mesh mesh;
  for (std::uint32_t ring = 0; ring < rings; ++ring) {
    const OnCircle around = on_circle(static_cast<double>(ring) / rings);
    for (std::uint32_t side = 0; side < sides; ++side) {
      const OnCircle across = on_circle(static_cast<double>(side) / sides);
      const double r = 1 + tube * across.x;
      add_vertex(mesh, {r * around.x, r * around.y, tube * across.y});
    }
  }
  const auto at = [&](std::uint32_t ring, std::uint32_t side) { return ring % rings * sides + side % sides; };
  for (std::uint32_t ring = 0; ring < rings; ++ring) {
    for (std::uint32_t side = 0; side < sides; ++side)
      add_quad(mesh, at(ring, side), at(ring + 1, side), at(ring + 1, side + 1), at(ring, side + 1));
  }
  return {std::to_string(rings) + " x " + std::to_string(sides), outward(std::move(mesh))};
}

/// Spikes and pits: concave and convex edges of every angle, saddle-shaped vertices.
Shape make_star(std::uint64_t round, test::Random& random) {
  const std::uint64_t n = strided(round, 1, 6);
  const int level = static_cast<int>(round % 5);
  return {"level " + std::to_string(level) + ", radii from " + tenth_text(n),
          spiky(test::sphere_mesh(level), tenth(n), random)};
}

/// Walls of 1e-1 to 1e-14 around cavities around bodies.
Shape make_shells(std::uint64_t round, test::Random& random) {
  const std::uint64_t n = strided(round, 1, 14);
  Mesh body = test::sphere_mesh(static_cast<int>(random.below(4)));
  if (round % 2 == 1) body = spiky(std::move(body), 0.3, random);
  const std::uint64_t count = 2 + random.below(4);
  Mesh mesh;
  double size = 1;
  for (std::uint64_t i = 0; i < count; ++i) {
    add_mesh(mesh, scaled(body, size), i % 2 == 1);
    size -= size * (i % 2 == 0 ? tenth(n) : std::max(tenth(n), random.between(0, 0.2)));
  }
  return {std::to_string(count) + " with walls of " + tenth_text(n), std::move(mesh)};
}

}  // namespace cdfr::soak
