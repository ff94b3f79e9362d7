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
///  - otherwise the ray has crossed the medial axis: the cube is halved again, depth first. Pieces that the
///  contour provably
///    misses (field/distance_above.h) are dropped; centres and corners are tried as above, until one point of
///    the contour is found no farther than E/2 from c.
/// Any x on the contour lies in some cube that passes, within E/2 of its centre, so within E of that cube's
/// point. A cube that 2^-10 of its edge, or a fixed number of trials, leaves undecided gives the place where
/// the value came closest, with an infinite error: nothing says that the contour is near. It happens where
/// the height is the depth of a medial sheet to the last bits.
///
/// Rule::paper only differs at the end: cubes of its final size that pass give their centres.
///
/// Where the sign jumps (Level), a point counts only on the contour's side, and a cube without triangles that
/// the winding number keeps on the other side (field/winding.h) is excluded.
#pragma once

#include <cstdint>
#include <vector>

#include "cdfr/core/sinks.h"
#include "cdfr/core/types.h"
#include "contour/cube.h"
#include "contour/level.h"
#include "field/field_data.h"

namespace cdfr {

struct DescentCounts {
  std::uint64_t evaluations = 0, undecided = 0;

  void add(const DescentCounts& other) noexcept {
    evaluations += other.evaluations;
    undecided += other.undecided;
  }
};

class Descent {
 public:
  /// Points are appended to `points` in Morton order.
  Descent(const FieldData& field, const Level& level, std::vector<ContourPoint>& points)
      : field_(field), level_(level), points_(points) {}

  /// Precondition: the cube passes.
  void run(const Cube& cube);
  /// A cube of the final size.
  void finish(const Cube& cube);
  const DescentCounts& counts() const noexcept { return counts_; }
  void clear_counts() noexcept { counts_ = {}; }

 private:
  /// What is known of a cube of final size while it is halved.
  struct Stuck {
    Cube cube;
    Sample centre;
    Sample highest;  ///< of those below the height; of value -inf if there is none yet
    int trials = 0;
    double last = 0;  ///< value of the last sample
    bool found = false;
    bool excluded = true;  ///< so far every piece was
  };

  Sample sample(const Vec3& x) noexcept;
  void put_centre(const Sample& at);
  bool put_point(const Sample& at, const Cube& within);
  bool put_away(const Sample& at, const Cube& within);
  bool put_along(const Sample& at, const Vec3& direction, const Cube& within);
  bool put_at_sheet(const Sample& at, const Vec3& along, const Sample& beyond, const Cube& within);
  bool put(const Vec3& position, const Sample& from, double error, const Cube& within);
  bool put_between(const Sample& below, const Sample& above, const Cube& within);
  bool put_from_highest(const Stuck& stuck);
  bool try_corners(const Cube& piece, Stuck& stuck);
  bool try_sample(const Vec3& x, Stuck& stuck);
  void halve(const Cube& piece, int times, Stuck& stuck);
  bool off_side(const Cube& cube, double value) const noexcept;

  const FieldData& field_;
  const Level& level_;
  std::vector<ContourPoint>& points_;
  DescentCounts counts_;
  double missed_ = 0;  ///< in this cube, the highest value at a sheet that is at the height to the last bits
};

}  // namespace cdfr
