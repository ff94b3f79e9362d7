/// Where a point's side is hardest to tell: on, at and around the corners, edges and faces of a mesh.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "cdfr/field/field.h"
#include "cdfr/mesh/mesh.h"
#include "support/random.h"

namespace cdfr::soak {

/// Draws points for a mesh. Thread safe: what is random comes in by argument.
class PointSource {
 public:
  /// `mesh` as welded() leaves it. `field` only helps to find the medial axis.
  PointSource(const Mesh& mesh, const Field& field);

  Vec3 draw(test::Random& random) const;

 private:
  /// A point of the surface with a direction that leads away from it: of a face its normal, of an edge or a
  /// vertex a mean of the normals around, so inside the cone of points that are closest to it if there is
  /// one.
  struct Site {
    Vec3 at, away;
  };
  Site on_face(std::uint32_t triangle, test::Random& random) const;
  Site on_edge(std::uint32_t triangle, test::Random& random) const;
  Site on_vertex(std::uint32_t triangle, test::Random& random) const;
  Site anywhere(test::Random& random) const;

  double distance(test::Random& random) const;
  Vec3 some_vertex(test::Random& random) const;
  Vec3 in_common_plane(test::Random& random) const;
  Vec3 with_borrowed_coordinates(test::Random& random) const;
  Vec3 on_medial_axis(test::Random& random) const;
  Vec3 far_away(test::Random& random) const;
  Vec3 normal(std::uint32_t triangle) const;

  const Mesh& mesh_;
  const Field& field_;
  Box box_;
  double size_ = 0;
  std::vector<std::array<std::uint32_t, 3>> neighbours_;  ///< across edge k
  std::vector<std::uint64_t> first_around_;               ///< of a vertex, in around_
  std::vector<std::uint32_t> around_;                     ///< triangles by vertex
};

}  // namespace cdfr::soak
