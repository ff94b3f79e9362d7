#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "core/vector.h"
#include "render/draw.h"

namespace cdfr {
namespace {

// A disc seen edge-on still has this radius, in samples: a thin rim must not drop out between samples.
constexpr double least_radius = 0.75;
// A disc seen edge-on has no bound to its slope; one over this is the bound.
constexpr double least_facing = 1.0 / 64;

class SplatPainter {
 public:
  SplatPainter(double radius, Layer& layer) : radius_(std::max(radius, least_radius)), layer_(layer) {}

  /// `facing` is a unit vector, or zero if the point has no normal.
  void draw(const Eigen::Vector3d& centre, const Eigen::Vector3d& facing) const {
    const double first_row = std::max(std::ceil(centre.y() - radius_ - 0.5), double(layer_.first_row()));
    const double last_row = std::min(std::floor(centre.y() + radius_ - 0.5), double(layer_.end_row() - 1));
    const double first_column = std::max(std::ceil(centre.x() - radius_ - 0.5), 0.0);
    const double last_column = std::min(std::floor(centre.x() + radius_ - 0.5), double(layer_.width() - 1));
    if (!(first_row <= last_row && first_column <= last_column)) return;
    const double towards_viewer = std::max(-facing.z(), least_facing);
    const double slope_x = facing.x() / towards_viewer, slope_y = facing.y() / towards_viewer;
    Sample sample;
    if (!facing.isZero(0)) {
      sample = {0, static_cast<float>(facing.x()), static_cast<float>(facing.y()),
                static_cast<float>(facing.z())};
    }
    for (int row = static_cast<int>(first_row); row <= static_cast<int>(last_row); ++row) {
      const double dy = row + 0.5 - centre.y();
      for (int column = static_cast<int>(first_column); column <= static_cast<int>(last_column); ++column) {
        const double dx = column + 0.5 - centre.x();
        const double dz = slope_x * dx + slope_y * dy;
        const double in_picture = dx * dx + dy * dy;
        if (in_picture > least_radius * least_radius && in_picture + dz * dz > radius_ * radius_) continue;
        sample.depth = static_cast<float>(centre.z() + std::clamp(dz, -radius_, radius_));
        Sample& nearest = layer_.at(column, row);
        if (sample.depth < nearest.depth) nearest = sample;
      }
    }
  }

 private:
  double radius_;
  Layer& layer_;
};

}  // namespace

void draw_points(std::span<const ContourPoint> points, const View& view, double radius, Layer& layer) {
  const SplatPainter painter(radius, layer);
  for (const ContourPoint& point : points) {
    const Eigen::Vector3d normal = to_eigen(point.normal);
    const double length = normal.norm();
    const bool good = length > 0 && std::isfinite(length);
    painter.draw(view.place(to_eigen(point.position)),
                 good ? view.facing(normal / length) : Eigen::Vector3d::Zero().eval());
  }
}

}  // namespace cdfr
