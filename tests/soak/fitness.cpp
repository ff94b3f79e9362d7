#include "soak/fitness.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <numeric>
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

std::vector<std::uint32_t> one_triangle_a_body(const Mesh& mesh, const DirectedEdges& edges) {
  std::vector<bool> seen(mesh.triangles.size(), false);
  std::vector<std::uint32_t> firsts, open;
  for (std::uint32_t start = 0; start < seen.size(); ++start) {
    if (seen[start]) continue;
    firsts.push_back(start);
    seen[start] = true;
    open.push_back(start);
    while (!open.empty()) {
      const Triangle t = mesh.triangles[open.back()];
      open.pop_back();
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t other = edges.at({t[(k + 1) % 3], t[k]});
        if (seen[other]) continue;
        seen[other] = true;
        open.push_back(other);
      }
    }
  }
  return firsts;
}

/// The winding numbers at points on both sides of a triangle and close to it.
bool winds_as_a_solid(const Mesh& mesh, const Triangle& t, const SideOracle& oracle) {
  test::Random random(1);
  const Vec3 a = mesh.vertices[t[0]], b = mesh.vertices[t[1]], c = mesh.vertices[t[2]];
  const double size = std::max({std::fabs(b.x - a.x), std::fabs(b.y - a.y), std::fabs(b.z - a.z),
                                std::fabs(c.x - a.x), std::fabs(c.y - a.y), std::fabs(c.z - a.z)});
  for (int i = 0; i < 200; ++i) {
    const double u = random.between(0, 0.5), v = random.between(0, 0.5);
    const double off = std::ldexp(size, -static_cast<int>(random.below(52)));
    const auto near = [&](double x, double y, double z) {
      return x + u * (y - x) + v * (z - x) + off * random.between(-1, 1);
    };
    const int winding = oracle.winding({near(a.x, b.x, c.x), near(a.y, b.y, c.y), near(a.z, b.z, c.z)}).value_or(0);
    if (winding != 0 && winding != 1) return false;
  }
  return true;
}

}  // namespace

std::string why_unfit(const Mesh& mesh, const SideOracle& oracle) {
  const std::optional<DirectedEdges> edges = closed_edges(mesh.triangles);
  if (!edges) return "not closed, or an edge is used more than once each way";
  const std::optional<Mesh> proper = without_flat_triangles(mesh);
  if (!proper) return "triangles of no area that cannot be flipped away";
  const std::optional<Surface> surface = surface_of(*proper);
  if (!surface) return "a vertex or an edge where bodies touch";
  if (CGAL::Polygon_mesh_processing::does_self_intersect(*surface)) return "touches or crosses itself";
  for (const std::uint32_t first : one_triangle_a_body(mesh, *edges)) {
    if (!winds_as_a_solid(mesh, mesh.triangles[first], oracle)) return "inside out, or bodies within bodies";
  }
  return "";
}

}  // namespace cdfr::soak
