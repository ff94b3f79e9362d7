/// On which side of a closed mesh a point is, by CGAL's exact predicates and a ray of our own.
///
/// The ray goes up from p' = p + (e, e^2, 0) for an infinitely small e, decided by signs alone (simulation of
/// simplicity), so it meets no edge, no vertex and no upright triangle: nothing is tried again. A point off
/// the surface has p' on its own side. Triangles of no area can be left out, for what is counted are the sets
/// of points that the triangles cover, not their borders: a set of no area is missed by p' whatever it is
/// bordered by.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "cdfr/mesh/mesh.h"
#include "soak/box_tree.h"

namespace cdfr::soak {

class SideOracle {
 public:
  /// Precondition: every edge is used as often one way as the other.
  explicit SideOracle(const Mesh& mesh);

  /// How often the surface winds around p; none if p is on it.
  std::optional<int> winding(Vec3 p) const;

  /// The winding number just in front of triangle t where the vertical line through (x, y) meets it; none if
  /// it does not, or if another triangle is met at the same height. Exact.
  std::optional<int> winding_in_front(const std::array<Vec3, 3>& t, double x, double y) const;

  /// Whether the surface is at most `reach` away from p. Exact, and slow.
  bool within(Vec3 p, double reach) const;

 private:
  using Corners = std::array<Vec3, 3>;
  std::vector<Corners> triangles_;  ///< those that have an area
  BoxTree tree_;
};

}  // namespace cdfr::soak
