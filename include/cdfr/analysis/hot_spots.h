/// Hot spots: the places of a part that are deeper than all around them, and the necks between them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "cdfr/analysis/ball.h"
#include "cdfr/core/api.h"
#include "cdfr/core/result.h"
#include "cdfr/core/run.h"
#include "cdfr/core/types.h"
#include "cdfr/field/field.h"

namespace cdfr {

struct HotSpotOptions {
  /// e, in the mesh's unit, of necks and prominences; 0 takes the longest side / 1000 or a twentieth of the
  /// greatest depth, whichever is more.
  double error = 0;
  /// A hot spot is deeper by more than this than the deepest neck that leads on to a deeper one, or than 0
  /// where none does. At least 2 e; 0 takes 2 e or a twentieth of the greatest depth, whichever is more.
  double prominence = 0;
  /// Patches that metal is fed through. Empty: HotSpot::feed says nothing.
  std::vector<std::uint32_t> feeders{};
};

/// The narrowest place on the widest way from one place inside to another: the smallest of the balls that are
/// met on it, and there is no way whose smallest is larger by more than the error (depth_tree.h says how sure
/// that is).
struct Neck {
  Vec3 centre;
  double radius = 0;
  double error = 0;  ///< e
};

struct HotSpot {
  static constexpr std::size_t none = ~std::size_t{0};

  InscribedBall ball;          ///< the largest around
  double prominence = 0;       ///< its radius less that of its neck; of the deepest of a body its radius
  std::size_t towards = none;  ///< place in HotSpots::spots of the deeper one behind the neck; none for the
                               ///< deepest of a body
  Neck neck;                   ///< on the way there
  /// The greatest depth found on the sphere about the ball's centre of twice its radius, to within e: what
  /// the walls that lead away are good for; 0 if none does. On an even plate, and in a bar, it is the ball's
  /// radius.
  double wall = 0;
  double isolation = 0;  ///< ball.radius / wall; infinite if no wall leads away
  bool fed = false;      ///< some way leads to a ball that touches a feeder
  Neck feed;             ///< on the widest of them; the ball itself if that touches one. Heuvers' circles
};

struct HotSpots {
  double error = 0, prominence = 0;  ///< as they were taken
  std::vector<HotSpot> spots;        ///< by the ball's radius, the largest first
  std::uint64_t critical_cells = 0;
};

/// All local maxima of the depth with a prominence above options.prominence (src/analysis/depth_tree.h).
/// Maxima that are nowhere more than e apart in depth along a path, such as the middle of a plate, are one.
/// Same bits for any number of threads. Time goes with the area of the part's middle surfaces, where walls
/// face each other, over e^2. Errors: bad_option (not finite or negative; a feeder that no triangle is of;
/// error below 2^-18 of the octree's cells of level 0 or 1024 ulp; prominence below 2 e), not_closed (an
/// unsigned field, or an open mesh: the sign has to change on the surface alone), cancelled; status(). Thread
/// safe.
CDFR_API Result<HotSpots> hot_spots(const Field& field, const HotSpotOptions& options = {},
                                    const Run& run = {});

}  // namespace cdfr
