/// CGAL's tree of boxes in double, with the search tree that gives each query its first bound.
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>

#include <cmath>
#include <vector>

#include "malloc_bytes.h"
#include "system.h"

namespace cdfr::bench {
namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Triangles = std::vector<Kernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

class CgalSystem final : public System {
 public:
  explicit CgalSystem(const Mesh& mesh) {
    const std::size_t before = malloc_bytes();
    const auto corner = [&](std::uint32_t v) {
      const Vec3& p = mesh.vertices[v];
      return Kernel::Point_3(p.x, p.y, p.z);
    };
    triangles_.reserve(mesh.triangles.size());
    for (const Triangle& t : mesh.triangles)
      triangles_.emplace_back(corner(t[0]), corner(t[1]), corner(t[2]));
    tree_.insert(triangles_.begin(), triangles_.end());
    tree_.build();
    tree_.accelerate_distance_queries();
    bytes_ = malloc_bytes() - before;
  }

  std::size_t bytes() const override { return bytes_; }
  void singles(std::span<const Vec3> points, std::span<double> out) const override {
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vec3& p = points[i];
      out[i] = std::sqrt(tree_.squared_distance(Kernel::Point_3(p.x, p.y, p.z)));
    }
  }

 private:
  Triangles triangles_;
  Tree tree_;
  std::size_t bytes_ = 0;
};

}  // namespace

Result<std::unique_ptr<System>> build_cgal(const Mesh& mesh, unsigned) {
  return {std::make_unique<CgalSystem>(mesh)};
}

}  // namespace cdfr::bench
