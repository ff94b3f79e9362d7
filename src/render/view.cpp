#include "render/view.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/vector.h"

namespace cdfr {
namespace {

constexpr int least_side = 16, greatest_side = 16384;
constexpr double filled_share = 0.92;
// Directions closer than about a millionth of a degree leave the picture's upright to rounding.
constexpr double least_sine = 0x1p-25;

/// Unit vector, or zero if there is none. Brought to size 1 first, so that squares neither vanish nor
/// overflow.
Eigen::Vector3d direction(Vec3 v) {
  const Eigen::Vector3d raw = to_eigen(v);
  const double size = raw.cwiseAbs().maxCoeff();
  if (!raw.allFinite() || size == 0) return Eigen::Vector3d::Zero();
  const Eigen::Vector3d scaled = raw / size;
  return scaled / scaled.norm();
}

Error refused(const char* text) { return {Code::bad_option, 0, text}; }

}  // namespace

Result<View> View::fit(const SplatOptions& options, const Box& box) {
  const auto side_is_good = [](int side) { return side >= least_side && side <= greatest_side; };
  if (!side_is_good(options.width) || !side_is_good(options.height)) {
    return refused("width and height are 16 to 16384 pixels");
  }
  View view;
  view.width_ = options.width;
  view.height_ = options.height;
  view.towards_ = direction(options.towards);
  if (view.towards_.isZero(0)) return refused("the viewing direction must be finite and not zero");
  const Eigen::Vector3d right = view.towards_.cross(direction(options.up));
  if (!(right.norm() > least_sine)) {
    return refused("the upward direction must be finite, not zero and not along the viewing direction");
  }
  view.right_ = right / right.norm();
  view.down_ = view.towards_.cross(view.right_);

  const Eigen::Vector3d lo = to_eigen(box.lo), hi = to_eigen(box.hi);
  view.centre_ = lo + (hi - lo) / 2;
  view.middle_ = Eigen::Vector3d(options.width, options.height, 0) * (samples_per_pixel / 2.0);
  const Eigen::Vector3d half = (hi - lo) / 2;
  const double reach_x = view.right_.cwiseAbs().dot(half), reach_y = view.down_.cwiseAbs().dot(half);
  // A box without extent in the picture is one spot at any scale; the largest side keeps depths in range.
  const double tightest = std::max(reach_x / view.middle_.x(), reach_y / view.middle_.y()) / filled_share;
  const double flattest = half.maxCoeff() / view.middle_.x() * 0x1p-20;
  if (half.maxCoeff() > 0) view.scale_ = 1 / std::max(tightest, flattest);
  view.depth_ = view.scale_ * view.towards_.cwiseAbs().dot(half);
  return view;
}

Eigen::Vector3d View::facing(const Eigen::Vector3d& normal) const {
  const Eigen::Vector3d turned = turn(normal);
  return turned.z() > 0 ? Eigen::Vector3d(-turned) : turned;
}

}  // namespace cdfr
