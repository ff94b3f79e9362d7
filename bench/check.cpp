#include "check.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace cdfr::bench {
namespace {

std::size_t differing(std::span<const double> a, std::span<const double> b) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    count += std::bit_cast<std::uint64_t>(a[i]) != std::bit_cast<std::uint64_t>(b[i]);
  }
  return count;
}

std::size_t differing_in_plane(const System& system, const Course& course) {
  const std::size_t plane = course.planes_peers.front().first;
  const std::vector<Vec3> points = course.grid.planes(plane, 1);
  std::vector<double> filled(points.size()), asked(points.size());
  system.planes(course.grid, plane, 1, filled, 1);
  system.singles(points, asked);
  return differing(filled, asked);
}

}  // namespace

Check check(const System& system, const Contest& contest) {
  const Truth& truth = contest.truth;
  Check result{.points = truth.points.size()};
  std::vector<double> out(truth.points.size());
  system.batch(truth.points, out, 1);
  result.different = differing(out, truth.distances) + differing_in_plane(system, contest.course);
  system.singles(truth.points, out);
  result.different += differing(out, truth.distances);
  for (std::size_t i = 0; i < out.size(); ++i) {
    const double error = std::abs(std::abs(out[i]) - std::abs(truth.distances[i])) / contest.course.diagonal;
    // No number at all is the worst that can be said.
    result.worst_error =
        std::max(result.worst_error, std::isnan(error) ? std::numeric_limits<double>::infinity() : error);
  }
  return result;
}

}  // namespace cdfr::bench
