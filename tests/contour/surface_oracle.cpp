#include "contour/surface_oracle.h"

#ifdef CDFR_SURFACE_ORACLE
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>

#include <array>
#include <vector>
#endif

namespace cdfr::test {

#ifdef CDFR_SURFACE_ORACLE
SurfaceVerdict judge_surface(const Mesh& mesh) {
  namespace processing = CGAL::Polygon_mesh_processing;
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  std::vector<Kernel::Point_3> points;
  for (const Vec3& v : mesh.vertices) points.emplace_back(v.x, v.y, v.z);
  std::vector<std::array<std::size_t, 3>> triangles;
  for (const Triangle& t : mesh.triangles) triangles.push_back({t[0], t[1], t[2]});
  if (!processing::is_polygon_soup_a_polygon_mesh(triangles)) return {false, true, false};
  CGAL::Surface_mesh<Kernel::Point_3> surface;
  processing::polygon_soup_to_polygon_mesh(points, triangles, surface);
  SurfaceVerdict verdict;
  verdict.closed = CGAL::is_closed(surface);
  verdict.meets_itself = processing::does_self_intersect(surface);
  verdict.bounds_volume = verdict.closed && !verdict.meets_itself && processing::does_bound_a_volume(surface);
  return verdict;
}
bool has_surface_oracle() { return true; }
#else
SurfaceVerdict judge_surface(const Mesh&) { return {}; }
bool has_surface_oracle() { return false; }
#endif

}  // namespace cdfr::test
