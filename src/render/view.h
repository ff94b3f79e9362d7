/// Where a point of space lands in the picture.
#pragma once

#include <Eigen/Core>

#include "cdfr/core/result.h"
#include "cdfr/core/types.h"
#include "cdfr/render/splat.h"

namespace cdfr {

/// Samples along each edge of a pixel; their mean is the pixel.
inline constexpr int samples_per_pixel = 2;

/// Orthographic. In the picture x goes right, y down and depth away from the viewer, all in samples, so that
/// slopes are pure numbers; the centre of the fitted box has depth 0.
class View {
 public:
  /// Fits the box into the picture. Errors: bad_option. Precondition: the box's coordinates are within 2^200.
  static Result<View> fit(const SplatOptions& options, const Box& box);

  Eigen::Vector3d place(const Eigen::Vector3d& point) const {
    return middle_ + scale_ * turn(point - centre_);
  }
  /// A direction; what points away from the viewer is turned round, for a surface is seen from either side.
  Eigen::Vector3d facing(const Eigen::Vector3d& normal) const;

  int width() const noexcept { return width_; }  ///< of the picture, in pixels
  int height() const noexcept { return height_; }
  double scale() const noexcept { return scale_; }  ///< samples a unit
  double depth() const noexcept { return depth_; }  ///< of the fitted box's farthest corner

 private:
  // Three dot products and no matrix product, which some processors would fuse.
  Eigen::Vector3d turn(const Eigen::Vector3d& v) const {
    return {right_.dot(v), down_.dot(v), towards_.dot(v)};
  }

  int width_ = 0, height_ = 0;
  double scale_ = 1, depth_ = 0;
  Eigen::Vector3d right_, down_, towards_, centre_, middle_;
};

}  // namespace cdfr
