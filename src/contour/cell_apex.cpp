#include "contour/cell_apex.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "contour/qef.h"
#include "core/vector.h"
#include "field/query.h"

namespace cdfr {
namespace {

/// Of the tolerance: a distance that is right but for rounding and curvature.
constexpr double good_share = 1.0 / 256;
/// Spread of normals, as a share of the number of planes, from which a direction counts: 0.06 and 0.4 radians
/// about.
constexpr double small_spread = 1e-3, clear_spread = 4e-2;

/// Of the tolerance: what a corner stands out by along the mean normal, to be looked for.
constexpr double visible_share = 1.0 / 16;

/// Mean of the cosines of the gradients with their mean.
constexpr double gentle_cosine = 0.95;

struct Tangents {
  PlaneMeeting meeting;
  Eigen::Vector3d normal;  ///< sum of the gradients by weight; shorter the more they spread
  double weight = 0;
  Eigen::Vector3d round;  ///< mean, moved along the mean normal
};

Tangents tangents_about(const Eigen::Vector3d& mean, std::span<const WeightedCrossing> crossings) {
  Tangents tangents{{}, {}, 0, mean};
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  double height = 0, weight = 0;
  for (const WeightedCrossing& at : crossings) {
    const Eigen::Vector3d gradient = to_eigen(at.crossing->gradient);
    const double offset = gradient.dot(to_eigen(at.crossing->position) - mean) - at.crossing->excess;
    tangents.meeting.add(gradient, offset, at.weight);
    normal += at.weight * gradient;
    height += at.weight * offset;
    weight += at.weight;
  }
  const double square = normal.squaredNorm();
  tangents.normal = normal;
  tangents.weight = weight;
  if (square > 0.01 * weight * weight) tangents.round = mean + normal * (height / square);
  return tangents;
}

/// Candidates in the order of preference; measured until one is good.
class Choice {
 public:
  Choice(const Sought& sought, SurfaceTally& tally) : sought_(sought), tally_(tally) {}

  bool offer(const Eigen::Vector3d& x) {
    ++tally_.evaluations;
    const double excess = std::fabs(signed_distance(sought_.field, from_eigen(x)) - sought_.distance);
    if (least_ < 0 || excess < least_) {
      least_ = excess;
      best_ = x;
    }
    return least_ <= good_share * sought_.tolerance;
  }
  Eigen::Vector3d best() const {
    tally_.largest_error = std::max(tally_.largest_error, least_);
    return best_;
  }

 private:
  const Sought& sought_;
  SurfaceTally& tally_;
  double least_ = -1;
  Eigen::Vector3d best_;
};

}  // namespace

Eigen::Vector3d cell_apex(const Sought& sought, const PlainCube& cube, const Eigen::Vector3d& mean,
                          std::span<const WeightedCrossing> crossings, SurfaceTally& tally) {
  const Tangents tangents = tangents_about(mean, crossings);
  int rank = 0;
  const Eigen::Vector3d sharp = mean + tangents.meeting.point(small_spread, rank);
  const Eigen::Vector3d round = cube.held(tangents.round);
  if (rank < 2) return round;
  // On a gently round piece both are as good.
  const double length = tangents.normal.norm();
  if (length > gentle_cosine * tangents.weight &&
      std::fabs(tangents.normal.dot(sharp - round)) <= visible_share * sought.tolerance * length)
    return round;
  Choice choice(sought, tally);
  if (cube.has(sharp) && choice.offer(sharp)) return choice.best();
  const Eigen::Vector3d clear = mean + tangents.meeting.point(clear_spread, rank);
  if (cube.has(clear) && clear != sharp && choice.offer(clear)) return choice.best();
  if (!cube.has(clear)) {
    const Eigen::Vector3d hair = Eigen::Vector3d::Constant(cube.size * hair_share);
    const Eigen::Vector3d lo = cube.lo + hair - mean,
                          hi = cube.lo + (Eigen::Vector3d::Constant(cube.size) - hair) - mean;
    if (choice.offer(cube.held(mean + tangents.meeting.point_in(lo, hi)))) return choice.best();
  }
  if (!choice.offer(round)) choice.offer(mean);
  return choice.best();
}

}  // namespace cdfr
