#include "analysis/largest_ball.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "core/vector.h"
#include "field/batch.h"
#include "geometry/box_distance.h"
#include "geometry/query_range.h"

namespace cdfr {
namespace {

/// Closest points of one ball before its bracket is halved instead.
constexpr int most_steps = 12;

/// One ball under way: feasible at `lower`, infeasible at `upper`.
class Ball {
 public:
  Ball(const WallPoint& at, const BallOptions& options, const Box& box, std::uint32_t number) noexcept
      : p_(to_eigen(at.position)), u_(to_eigen(at.direction)), facet_(at.facet), number_(number) {
    upper_ = std::min(options.largest, options.outside ? options.largest : fitting(box, options));
    asked_ = upper_;
  }

  std::uint32_t number() const noexcept { return number_; }
  Vec3 centre() const noexcept { return from_eigen(p_ + asked_ * u_); }

  /// True if it is done.
  bool take(const Closest& closest, const BallOptions& options, double depth) noexcept {
    const double excess = asked_ - depth - facet_;
    if (!(excess > options.rounding)) {
      unmet_ = steps_ == 0;
      lower_ = asked_;
    } else {
      lower_bound_by(closest, excess, options);
    }
    ++steps_;
    if (unmet_ || std::isnan(depth)) return true;
    if (upper_ - lower_ <= options.tolerance) return true;
    // Less than the tolerance by more than the difference rounds by.
    asked_ = steps_ < most_steps ? upper_ - options.tolerance * (15.0 / 16) : lower_ + (upper_ - lower_) / 2;
    return false;
  }

  MeasuredWall wall() const noexcept {
    MeasuredWall wall;
    wall.thickness = unmet_ ? std::numeric_limits<double>::quiet_NaN() : 2 * lower_;
    if (unmet_) return wall;
    wall.error = 2 * (upper_ - lower_);
    wall.opposite_point = from_eigen(q_);
    wall.opposite = opposite_;
    wall.opposite_patch = patch_;
    return wall;
  }

 private:
  /// More than the largest radius that fits into the box: of a ball that comes D inside it from p, which each
  /// of six planes bounds.
  double fitting(const Box& box, const BallOptions& options) const noexcept {
    const Eigen::Array3d u = u_.array(), p = p_.array(), lo = to_eigen(box.lo).array(),
                         hi = to_eigen(box.hi).array();
    // Where a direction is an axis but for its rounding, the plane behind p bounds nothing.
    const Eigen::Array3d behind = (1 - u).max(0.0) + 0x1p-50, ahead = (1 + u).max(0.0) + 0x1p-50;
    const double reserve = facet_ + options.rounding;
    const double least =
        std::min(((p - lo + reserve) / behind).minCoeff(), ((hi - p + reserve) / ahead).minCoeff());
    return std::max(least, 0.0) * (1 + 1.0 / 16) + 4 * options.tolerance;
  }

  /// With q and u . (q - p) off by less than twice the rounding, r_q is rounded up.
  void lower_bound_by(const Closest& closest, double excess, const BallOptions& options) noexcept {
    q_ = to_eigen(closest.point);
    opposite_ = closest.triangle;
    patch_ = closest.patch;
    upper_ = std::min(upper_, asked_ - (excess - options.rounding) / 2);
    const Eigen::Vector3d way = q_ - p_;
    const double doubt = 2 * options.rounding, far = way.norm() + doubt;
    const double ahead = u_.dot(way) - facet_ - doubt;
    if (!(ahead > 0)) return;
    const double radius = (far * far - facet_ * facet_) / (2 * ahead) * (1 + 0x1p-48);
    upper_ = std::max(std::min(upper_, radius), lower_);
  }

  Eigen::Vector3d p_, u_, q_ = Eigen::Vector3d::Zero();
  double facet_, lower_ = 0, upper_ = 0, asked_ = 0;
  std::uint32_t number_, opposite_ = no_index, patch_ = 0;
  int steps_ = 0;
  bool unmet_ = false;
};

}  // namespace

double ball_rounding(const FieldData& field, double largest) noexcept {
  const Box& box = field.bounds();
  return 2 * point_rounding(std::max(largest_magnitude(box.lo), largest_magnitude(box.hi)) + largest);
}

std::uint64_t largest_balls(const FieldData& field, std::span<const WallPoint> points,
                            const BallOptions& options, std::span<MeasuredWall> walls, Progress& progress) {
  const bool jumps = !field.winding.empty();
  const double sign = options.outside ? 1 : -1;
  std::vector<Ball> balls;
  balls.reserve(points.size());
  for (const WallPoint& point : points)
    balls.emplace_back(point, options, field.bounds(), static_cast<std::uint32_t>(balls.size()));
  std::vector<Vec3> centres;
  std::vector<Closest> closest;
  std::uint64_t asked = 0;
  while (!balls.empty()) {
    centres.clear();
    for (const Ball& ball : balls) centres.push_back(ball.centre());
    closest.resize(balls.size());
    if (!answer(field, Points(std::span<const Vec3>(centres)), 0, std::span<Closest>(closest), progress))
      break;
    asked += balls.size();
    std::size_t kept = 0;
    for (std::size_t i = 0; i < balls.size(); ++i) {
      const double depth = jumps ? std::fabs(closest[i].distance) : sign * closest[i].distance;
      if (balls[i].take(closest[i], options, depth)) {
        walls[balls[i].number()] = balls[i].wall();
      } else {
        balls[kept++] = balls[i];
      }
    }
    balls.erase(balls.begin() + static_cast<std::ptrdiff_t>(kept), balls.end());
  }
  return asked;
}

}  // namespace cdfr
