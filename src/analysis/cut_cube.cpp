#include "analysis/cut_cube.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace cdfr {
namespace {

/// Of the unit cube below the plane m.x = a, and how that grows with a.
struct Share {
  double volume, growth;
};

/// For 0 <= m1 <= m2 <= m3, of sum 1, and 0 <= a <= 1/2.
Share share_below(double m1, double m2, double m3, double a) noexcept {
  const double m12 = m1 + m2;
  if (a < m1) return {a * a * a / (6 * m1 * m2 * m3), a * a / (2 * m1 * m2 * m3)};
  if (a < m2) {
    const double first = m1 * m1 / (6 * m2 * m3);
    return {a * (a - m1) / (2 * m2 * m3) + first, (2 * a - m1) / (2 * m2 * m3)};
  }
  if (a >= m12 && m12 <= m3) return {(2 * a - m12) / (2 * m3), 1 / m3};
  const double all = 6 * m1 * m2 * m3, b1 = a - m1, b2 = a - m2, b3 = std::max(a - m3, 0.0);
  return {(a * a * a - b1 * b1 * b1 - b2 * b2 * b2 - b3 * b3 * b3) / all,
          3 * (a * a - b1 * b1 - b2 * b2 - b3 * b3) / all};
}

}  // namespace

CubeCut cut_cube(const Vec3& way, double offset, double half) noexcept {
  const double edge = 2 * half, cube = edge * edge * edge;
  std::array<double, 3> m{std::fabs(way.x), std::fabs(way.y), std::fabs(way.z)};
  const double sum = m[0] + m[1] + m[2], length = std::sqrt(m[0] * m[0] + m[1] * m[1] + m[2] * m[2]);
  if (!(offset > -half * sum)) return {0, 0};
  if (offset >= half * sum) return {cube, 0};
  std::sort(m.begin(), m.end());
  const double a = (offset / (half * sum) + 1) / 2;
  const Share share = share_below(m[0] / sum, m[1] / sum, m[2] / sum, std::min(a, 1 - a));
  const double volume = std::clamp(share.volume, 0.0, 1.0);
  return {cube * (a <= 0.5 ? volume : 1 - volume), edge * edge * share.growth * length / sum};
}

}  // namespace cdfr
