/// Depth inside a mesh by plain search through buckets of triangles, for tests: how deep a place is, and
/// where the mesh is deeper than a bound, proven by the fact that depth changes no faster than one moves.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "cdfr/mesh/mesh.h"

namespace cdfr::test {

class DepthProbe {
 public:
  /// Buckets are cubes with an edge of `size`. The mesh is closed and must outlive the probe.
  DepthProbe(const Mesh& mesh, double size);

  double distance(Vec3 p) const;
  /// As distance(p) where that is between the bounds; else something on the right side of them.
  double distance(Vec3 p, double enough, double far) const;
  /// By counting the triangles above; right for any point that is not above an edge.
  bool inside(Vec3 p) const;

  struct Place {
    Vec3 point;
    double depth;
  };
  /// Centres of the cubes, down to the edge `finest`, in which the depth could exceed `bound`. Where none is,
  /// it does not.
  std::vector<Place> deeper_than(double bound, double finest) const;

  /// Along the line over (x, y) the surface is entered and left in turn.
  bool alternates(double x, double y) const;
  /// The same along lines over so many random places of the box.
  void expect_alternating(int places) const;

 private:
  struct Cube {
    Vec3 centre;
    double half;
  };
  std::vector<Cube> start() const;
  static void split(const Cube& cube, std::vector<Cube>& stack);
  std::size_t slot(double value, std::size_t axis) const;
  const std::vector<std::uint32_t>& bucket(std::size_t x, std::size_t y, std::size_t z) const;
  double nearest_in_shell(Vec3 p, int ring, double best) const;
  std::vector<std::pair<double, bool>> crossings(double x, double y) const;

  const Mesh& mesh_;
  double size_;
  Box box_;
  std::array<std::size_t, 3> counts_{};
  std::vector<std::vector<std::uint32_t>> buckets_;
};

}  // namespace cdfr::test
