/// A second opinion: CGAL's own Side_of_triangle_mesh, which shares the predicates with SideOracle but
/// neither tree nor ray.
#pragma once

#include <memory>
#include <optional>

#include "cdfr/mesh/mesh.h"

namespace cdfr::soak {

class SecondOracle {
 public:
  explicit SecondOracle(const Mesh& mesh);
  ~SecondOracle();

  /// -1 inside, 1 outside, 0 on the surface. None where CGAL's ray, which ends one unit from p, would be lost
  /// in rounding.
  std::optional<int> side(Vec3 p) const;

 private:
  struct Tree;
  std::unique_ptr<const Tree> tree_;
};

}  // namespace cdfr::soak
