#include "soak/second_oracle.h"

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>

#include "soak/welded.h"

namespace cdfr::soak {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Surface = CGAL::Surface_mesh<Point>;
using Primitive = CGAL::AABB_face_graph_triangle_primitive<Surface>;
using AabbTree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

/// Triangles of some area, each with corners of its own: which are neighbours does not matter to a ray.
Surface separate_triangles(const Mesh& mesh) {
  Surface surface;
  for (const Triangle& t : mesh.triangles) {
    const auto point = [&](std::size_t k) {
      const Vec3& v = mesh.vertices[t[k]];
      return Point(v.x, v.y, v.z);
    };
    if (CGAL::collinear(point(0), point(1), point(2))) continue;
    surface.add_face(surface.add_vertex(point(0)), surface.add_vertex(point(1)),
                     surface.add_vertex(point(2)));
  }
  return surface;
}

}  // namespace

struct SecondOracle::Tree {
  explicit Tree(const Mesh& mesh)
      : surface(separate_triangles(mesh)),
        tree(faces(surface).first, faces(surface).second, surface),
        side(tree),
        size(largest_coordinate(mesh)) {
    tree.build();
  }

  Surface surface;
  AabbTree tree;
  CGAL::Side_of_triangle_mesh<Surface, Kernel> side;
  double size;
};

SecondOracle::SecondOracle(const Mesh& mesh) : tree_(std::make_unique<Tree>(mesh)) {}
SecondOracle::~SecondOracle() = default;

std::optional<int> SecondOracle::side(Vec3 p) const {
  if (!(tree_->size > 1e-6 && tree_->size < 1e6)) return std::nullopt;
  const CGAL::Bounded_side side = tree_->side(Point(p.x, p.y, p.z));
  if (side == CGAL::ON_BOUNDARY) return 0;
  return side == CGAL::ON_BOUNDED_SIDE ? -1 : 1;
}

}  // namespace cdfr::soak
