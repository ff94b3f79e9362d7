#include <algorithm>
#include <vector>

#include "soak/families.h"

namespace cdfr::soak {
namespace {

/// One corner of a polygon that is seen whole from the origin: its place on the circle and its distance.
struct Corner {
  double turn = 0;
  double radius = 1;
};

/// Distinct turns, ascending, some of them as close as `gap`.
std::vector<double> turns(std::uint64_t count, double gap, test::Random& random) {
  std::vector<double> result;
  for (std::uint64_t i = 0; i < count; ++i) {
    result.push_back((static_cast<double>(i) + random.between(0, 0.9)) / static_cast<double>(count));
    if (gap > 0 && random.below(4) == 0) result.push_back(result.back() + gap);
  }
  std::ranges::sort(result);
  return result;
}

/// Slits and spikes, `gap` of a turn to each side of their middle.
std::vector<Corner> slit_polygon(std::uint64_t count, double gap, test::Random& random) {
  std::vector<Corner> corners;
  for (std::uint64_t i = 0; i < count; ++i) {
    const double turn = (static_cast<double>(i) + random.between(0.3, 0.7)) / static_cast<double>(count);
    const bool slit = random.below(2) == 0;
    const double far = random.between(0.6, 1), near = random.between(0.05, 0.4);
    corners.push_back({turn - gap, slit ? far : near});
    corners.push_back({turn, slit ? near : far});
    corners.push_back({turn + gap, slit ? far : near});
  }
  return corners;
}

Mesh extruded(const std::vector<Corner>& corners, double height) {
  Mesh mesh;
  const auto count = static_cast<std::uint32_t>(corners.size());
  for (const double z : {0.0, height}) {
    for (const Corner& corner : corners) {
      const OnCircle at = on_circle(corner.turn);
      add_vertex(mesh, {corner.radius * at.x, corner.radius * at.y, z});
    }
  }
  const std::uint32_t bottom = add_vertex(mesh, {0, 0, 0}), top = add_vertex(mesh, {0, 0, height});
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t j = (i + 1) % count;
    add_quad(mesh, i, j, count + j, count + i);
    mesh.triangles.push_back({bottom, j, i});
    mesh.triangles.push_back({top, count + i, count + j});
  }
  return mesh;
}

}  // namespace

/// Two fans of 100 or 1000 triangles over one ring that goes up and down: embedded whatever the ring's
/// heights are, for both are height fields over the same polygon, and one apex is above the other.
Shape make_fan(std::uint64_t round, test::Random& random) {
  const std::uint64_t valence = round % 2 == 0 ? 100 : 1000;
  const std::uint64_t n = strided(round, 0, 12);
  const double ripple = round % 3 == 0 ? 1 : tenth(n);
  const double least = round % 3 == 1 ? 1 : 0.1;
  Mesh mesh;
  for (const double turn : turns(valence, round % 4 == 3 ? tenth(8) : 0, random)) {
    const OnCircle at = on_circle(turn);
    const double r = random.between(least, 1.0 + (least == 1 ? 0 : 1e-9));
    const double saddle = at.x * at.x - at.y * at.y;
    add_vertex(mesh, {r * at.x, r * at.y, ripple * (round % 5 == 4 ? saddle : random.between(-1, 1))});
  }
  const auto count = static_cast<std::uint32_t>(mesh.vertices.size());
  const double height = random.between(-1, 1);
  const std::uint32_t top = add_vertex(mesh, {0, 0, height});
  const std::uint32_t bottom = add_vertex(mesh, {0, 0, height - tenth(n)});
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t j = (i + 1) % count;
    mesh.triangles.push_back({i, j, top});
    mesh.triangles.push_back({j, i, bottom});
  }
  return {"valence " + std::to_string(count) + ", thickness " + tenth_text(n), std::move(mesh)};
}

/// An extruded star: reflex and convex edges as narrow as 1e-14 of a turn, and apart or not by coplanar caps.
Shape make_gear(std::uint64_t round, test::Random& random) {
  const std::uint64_t n = strided(round, 2, 14);
  const std::uint64_t teeth = 3 + random.below(30);
  const double height = round % 3 == 0 ? 1 : tenth(strided(round, 1, 9));
  return {
      std::to_string(teeth) + " slits and spikes of " + tenth_text(n),
      extruded(slit_polygon(teeth, std::min(tenth(n), 0.1 / static_cast<double>(teeth)), random), height)};
}

}  // namespace cdfr::soak
