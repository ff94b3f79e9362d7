#include "analysis/plane_range.h"

#include <algorithm>
#include <cmath>

#include "analysis/cut_cube.h"

namespace cdfr {
namespace {

/// Shares of a direction below which a component is left out, and of a cube that its cut is off by, both with
/// room to spare (cut_cube.h).
constexpr double least_share = 0x1p-20, cut_share = 0x1p-27;

}  // namespace

void PlaneRange::add(double offset, const Vec3& way) noexcept {
  const LinearFunction function{offset, way.x, way.y, way.z};
  for (std::size_t i = 0; i < 4; ++i) {
    least_[i] = std::min(least_[i], function[i]);
    most_[i] = std::max(most_[i], function[i]);
  }
}

LinearFunction PlaneRange::middle() const noexcept {
  LinearFunction function;
  for (std::size_t i = 0; i < 4; ++i) function[i] = (least_[i] + most_[i]) / 2;
  return function;
}

double PlaneRange::spread(double half) const noexcept {
  double sum = 0;
  for (std::size_t i = 0; i < 4; ++i) sum += (most_[i] - least_[i]) / 2 * (i == 0 ? 1 : half);
  return sum;
}

VolumeBounds volume_above(const LinearFunction& function, double spread, double half) noexcept {
  Vec3 way{function[1], function[2], function[3]};
  const double largest = std::max({std::fabs(way.x), std::fabs(way.y), std::fabs(way.z)});
  for (double* component : {&way.x, &way.y, &way.z}) {
    if (std::fabs(*component) >= least_share * largest) continue;
    spread += std::fabs(*component) * half;
    *component = 0;
  }
  const double volume = 8 * half * half * half;
  return {std::max(cut_cube(way, function[0] - spread, half).volume - cut_share * volume, 0.0),
          std::min(cut_cube(way, function[0] + spread, half).volume + cut_share * volume, volume)};
}

}  // namespace cdfr
