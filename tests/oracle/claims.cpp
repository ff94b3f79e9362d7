#include "oracle/claims.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ios>
#include <sstream>

#include "oracle/vectors.h"

namespace cdfr::oracle {
namespace {

using Long = long double;

Long long_length(Long x, Long y, Long z) { return std::sqrt(x * x + y * y + z * z); }

/// How far the corners, combined, are from the point, in its worst coordinate.
double rebuild_error(const Closest& closest, const Corners& v) {
  const auto off = [&](double Vec3::*axis) {
    Long sum = -static_cast<Long>(closest.point.*axis);
    for (std::size_t i = 0; i < 3; ++i) sum += static_cast<Long>(closest.barycentric[i]) * (v[i].*axis);
    return std::abs(sum);
  };
  return static_cast<double>(std::max({off(&Vec3::x), off(&Vec3::y), off(&Vec3::z)}));
}

bool element_fits(const Closest& closest) {
  const std::size_t k = closest.element;
  switch (closest.feature) {
    case Feature::face:
      return k == 0;
    case Feature::edge:
      return k < 3 && closest.barycentric[(k + 2) % 3] == 0;
    case Feature::vertex:
      return k < 3 && closest.barycentric[k] == 1;
  }
  return false;
}

double beyond_unit_range(const std::array<double, 3>& b) {
  double worst = 0;
  for (const double x : b) worst = std::isnan(x) ? x : std::max({worst, -x, x - 1});
  return worst;
}

double direction_error(const Closest& closest, Vec3 x, const Exact& exact) {
  const auto off = [&](double Vec3::*axis, std::size_t i) {
    const Long away = static_cast<Long>(x.*axis) - approximate(exact.foot[i]);
    return static_cast<Long>(closest.distance) * (closest.gradient.*axis) - away;
  };
  const Long error = long_length(off(&Vec3::x, 0), off(&Vec3::y, 1), off(&Vec3::z, 2));
  const Long excess = error - 1e-12L * std::abs(closest.distance);
  return excess < 0 ? 0 : static_cast<double>(excess);
}

}  // namespace

const Bound& bound_of(Claim claim) noexcept {
  // Beyond the documented bounds: `consistent` allows 4 ulp of distance and 2 in each of three coordinates of
  // point; `barycentric_point` three products and three roundings of numbers up to M, and the point's own;
  // the direction of the gradient what those allow together.
  static constexpr std::array<Bound, claim_count> bounds{{{"distance", 4},
                                                          {"point", 2},
                                                          {"on_surface", 2},
                                                          {"consistent", 8},
                                                          {"barycentric_sum", 1e-12},
                                                          {"barycentric_range", 1e-12},
                                                          {"barycentric_point", 8},
                                                          {"element", 0},
                                                          {"gradient_length", 1e-12},
                                                          {"gradient_direction", 8}}};
  return bounds[static_cast<std::size_t>(claim)];
}

Errors errors_of(const Closest& closest, Vec3 x, const Corners& corners, const Exact& exact, double largest) {
  const double m = std::max(largest, largest_coordinate(x));
  const auto in_ulps = [&](double error) { return std::ldexp(error, -ulp_exponent(m)); };
  const Vec3 q = closest.point;
  const std::array<double, 3>& b = closest.barycentric;
  const Vec3 g = closest.gradient;
  const double size = std::abs(closest.distance);
  const Long apart =
      long_length(static_cast<Long>(x.x) - q.x, static_cast<Long>(x.y) - q.y, static_cast<Long>(x.z) - q.z);
  Errors errors{};
  const auto set = [&](Claim claim, double error) { errors[static_cast<std::size_t>(claim)] = error; };
  set(Claim::distance, exact.error_in_ulps(size, x, largest));
  set(Claim::point, exact.foot_error_in_ulps(q, x, largest));
  const bool finite = std::isfinite(q.x + q.y + q.z);
  set(Claim::on_surface, finite ? exact_distance(q, corners[0], corners[1], corners[2])
                                      .error_in_ulps(0, {}, largest_coordinate(corners))
                                : INFINITY);
  set(Claim::consistent, in_ulps(static_cast<double>(std::abs(apart - size))));
  set(Claim::barycentric_sum, static_cast<double>(std::abs(static_cast<Long>(b[0]) + b[1] + b[2] - 1)));
  set(Claim::barycentric_range, beyond_unit_range(b));
  set(Claim::barycentric_point, in_ulps(rebuild_error(closest, corners)));
  set(Claim::element, element_fits(closest) ? 0 : 1);
  set(Claim::gradient_length, static_cast<double>(std::abs(long_length(g.x, g.y, g.z) - 1)));
  set(Claim::gradient_direction, in_ulps(direction_error(closest, x, exact)));
  return errors;
}

void Worst::expect_within_bounds() const {
  for (std::size_t i = 0; i < claim_count; ++i) {
    const Bound& bound = bound_of(static_cast<Claim>(i));
    EXPECT_LE(worst_[i], bound.limit) << bound.name << " of " << where_[i];
  }
}

std::string Worst::text() const {
  std::ostringstream out;
  out.precision(3);
  for (std::size_t i = 0; i < claim_count; ++i) {
    out << (i > 0 ? ", " : "") << bound_of(static_cast<Claim>(i)).name << ' ' << worst_[i];
  }
  return out.str();
}

std::string replay(Vec3 x, const Corners& corners) {
  std::ostringstream out;
  out << std::hexfloat << "x {" << x.x << ", " << x.y << ", " << x.z << "} triangle";
  for (const Vec3& v : corners) out << " {" << v.x << ", " << v.y << ", " << v.z << '}';
  return out.str();
}

}  // namespace cdfr::oracle
