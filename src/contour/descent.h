/// From one cube of space to the contour's points in it, by sub-voxels.
///
/// A cube of edge s and centre c can meet the contour only if |value(c) - height| <= sqrt(3)/2 s: the
/// distance has slope 1. Cubes that pass are halved until sqrt(3)/2 s <= E/2; each one left gives a point on
/// the contour (promise 5):
///  - value above the height: the point on the segment from c to its foot at that height. Its foot is the
///  same, so it lies
///    on the contour exactly, no farther than E/2 from c.
///  - value below: the point at that height on the ray from the foot through c. If the value a hair beyond it
///  reaches the
///    height, the contour passes within that hair, for along the ray the value grows at most as fast as the
///    length.
///  - otherwise the ray has crossed the medial axis: the cube is halved again, corners are tried as well, and
///  pieces that
///    the contour provably misses (exclusion.h) are dropped.
/// Any x on the contour lies in some cube that passes, within E/2 of its centre, so within E of that cube's
/// point; in halved cubes a corner's point is within twice the half cube's diagonal, E again. What 2^-10 of a
/// sub-voxel leaves undecided is returned with an infinite error: nothing says that the contour is near.
#pragma once

#include <cstdint>
#include <vector>

#include "cdfr/core/sinks.h"
#include "cdfr/core/types.h"
#include "contour/level.h"
#include "field/field_data.h"

namespace cdfr {

/// A cube: a leaf of the octree, or one beyond the domain.
struct Cube {
  Vec3 lo;
  double size = 0;

  Vec3 centre() const noexcept { return {lo.x + size / 2, lo.y + size / 2, lo.z + size / 2}; }
  Cube octant(int child) const noexcept {
    const double half = size / 2;
    return {{lo.x + (child & 1 ? half : 0), lo.y + (child & 2 ? half : 0), lo.z + (child & 4 ? half : 0)},
            half};
  }
  double half_diagonal() const noexcept { return 0.8660254037844387 * size; }
};

struct DescentCounts {
  std::uint64_t visited = 0, productive = 0, evaluations = 0, undecided = 0;

  void add(const DescentCounts& other) noexcept {
    visited += other.visited;
    productive += other.productive;
    evaluations += other.evaluations;
    undecided += other.undecided;
  }
};

class Descent {
 public:
  /// Points are appended to `points` in Morton order.
  Descent(const FieldData& field, const Level& level, double tolerance, std::vector<ContourPoint>& points)
      : field_(field), level_(level), tolerance_(tolerance), points_(points) {}

  /// The whole cube. Counts it as visited if its centre's value allows the contour.
  void run(const Cube& cube);
  const DescentCounts& counts() const noexcept { return counts_; }

 private:
  bool passes(double value, const Cube& cube) const noexcept;
  double value_at_centre(const Cube& cube) noexcept;
  Sample sample(const Vec3& x) noexcept;
  void descend(const Cube& cube);
  void finish(const Cube& cube);
  bool put_point(const Sample& at);
  void put_toward(const Sample& at);
  bool put_away(const Sample& at);
  bool put_from_corner(const Cube& cube);
  void divide(const Cube& cube, int times);
  void put(const Vec3& position, const Vec3& normal, std::uint32_t triangle, double error);

  const FieldData& field_;
  const Level& level_;
  double tolerance_;
  std::vector<ContourPoint>& points_;
  DescentCounts counts_;
};

}  // namespace cdfr
