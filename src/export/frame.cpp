#include "export/frame.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cdfr {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

void grow(Box& box, Vec3 p, double radius) noexcept {
  box.lo = {std::min(box.lo.x, p.x - radius), std::min(box.lo.y, p.y - radius),
            std::min(box.lo.z, p.z - radius)};
  box.hi = {std::max(box.hi.x, p.x + radius), std::max(box.hi.y, p.y + radius),
            std::max(box.hi.z, p.z + radius)};
}

Box box_of(const PaintedMesh& painted) noexcept {
  Box box{{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};
  for (std::size_t i = 0; i < painted.mesh.vertices.size(); ++i) grow(box, painted.mesh.vertices[i], 0);
  for (const PaintedBall& ball : painted.balls) grow(box, ball.centre, ball.radius);
  for (const PaintedLabel& label : painted.labels) grow(box, label.place, 0);
  return box;
}

}  // namespace

Frame::Frame(const PaintedMesh& painted) noexcept : box_(box_of(painted)) {
  if (empty()) return;
  // Halves first: neither the sum nor the difference of two finite numbers need be finite.
  centre_ = {box_.lo.x / 2 + box_.hi.x / 2, box_.lo.y / 2 + box_.hi.y / 2, box_.lo.z / 2 + box_.hi.z / 2};
  const double reach =
      std::max({box_.hi.x / 2 - box_.lo.x / 2, box_.hi.y / 2 - box_.lo.y / 2, box_.hi.z / 2 - box_.lo.z / 2});
  if (reach > 0) size_ = std::ldexp(1.0, std::ilogb(reach));
}

double Frame::diagonal() const noexcept {
  const auto [lo, hi] = box();
  const Vec3 d{hi.x - lo.x, hi.y - lo.y, hi.z - lo.z};
  const double length = std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z);
  return length > 0 ? length : 1;
}

}  // namespace cdfr
