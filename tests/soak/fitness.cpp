#include "soak/fitness.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "soak/flat_triangles.h"
#include "soak/welded.h"
#include "support/random.h"

namespace cdfr::soak {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;

std::optional<Surface> surface_of(const Mesh& mesh) {
  Surface surface;
  for (const Vec3& v : mesh.vertices) surface.add_vertex({v.x, v.y, v.z});
  for (const Triangle& t : mesh.triangles) {
    const auto at = [&](std::size_t k) { return Surface::Vertex_index(t[k]); };
    if (surface.add_face(at(0), at(1), at(2)) == Surface::null_face()) return std::nullopt;
  }
  return surface;
}

using Body = std::vector<std::uint32_t>;

/// Triangles that are connected through edges.
std::vector<Body> bodies_of(const Mesh& mesh, const DirectedEdges& edges) {
  std::vector<bool> seen(mesh.triangles.size(), false);
  std::vector<Body> bodies;
  for (std::uint32_t start = 0; start < seen.size(); ++start) {
    if (seen[start]) continue;
    Body body{start};
    seen[start] = true;
    for (std::size_t i = 0; i < body.size(); ++i) {
      const Triangle t = mesh.triangles[body[i]];
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t other = edges.at(t[(k + 1) % 3], t[k]);
        if (!seen[other]) body.push_back(other);
        seen[other] = true;
      }
    }
    bodies.push_back(std::move(body));
  }
  return bodies;
}

/// The winding number in front of some triangle of the body: that of the space around it, or of its cavity.
/// None if no place was found where a vertical line meets a triangle and nothing else at the same height.
std::optional<int> winding_in_front(const Mesh& mesh, const Body& body, const SideOracle& oracle) {
  test::Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const Triangle& t = mesh.triangles[body[random.below(body.size())]];
    const Vec3 a = mesh.vertices[t[0]], b = mesh.vertices[t[1]], c = mesh.vertices[t[2]];
    const double u = random.between(0, 0.6), v = random.between(0, 0.6);
    const auto winding = oracle.winding_in_front({a, b, c}, a.x + u * (b.x - a.x) + v * (c.x - a.x),
                                                 a.y + u * (b.y - a.y) + v * (c.y - a.y));
    if (winding) return winding;
  }
  return std::nullopt;
}

bool supported(const Vec3& v) {
  const auto fits = [](double x) { return x == 0 || (std::fabs(x) >= 0x1p-200 && std::fabs(x) <= 0x1p200); };
  return fits(v.x) && fits(v.y) && fits(v.z);
}

}  // namespace

std::string why_unfit(const Mesh& mesh, const SideOracle& oracle) {
  if (mesh.triangles.empty()) return "no triangles";
  if (!std::ranges::all_of(mesh.vertices, supported)) return "coordinates beyond 2^-200 to 2^200";
  const std::optional<DirectedEdges> edges = closed_edges(mesh.triangles);
  if (!edges) return "not closed, or an edge is used more than once each way";
  const std::optional<Mesh> proper = without_flat_triangles(mesh, *edges);
  if (!proper) return "triangles of no area that cannot be flipped away";
  const std::optional<Surface> surface = surface_of(*proper);
  if (!surface) return "a vertex or an edge where bodies touch";
  if (CGAL::Polygon_mesh_processing::does_self_intersect(*surface)) return "touches or crosses itself";
  for (const Body& body : bodies_of(mesh, *edges)) {
    const std::optional<int> winding = winding_in_front(mesh, body, oracle);
    if (!winding) return "a body that is seen edge-on only";
    if (*winding != 0) return "inside out, or bodies within bodies";
  }
  return "";
}

}  // namespace cdfr::soak
