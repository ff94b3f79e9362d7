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

std::size_t differing_in_slab(const System& system, SampleGrid grid) {
  // Thick enough for samples above each other to be worked on together.
  grid.size[2] = 4;
  const std::vector<Vec3> points = points_of(grid, 0, grid.size[2]);
  std::vector<double> filled(points.size()), asked(points.size());
  system.fill(grid, filled, 1);
  system.singles(points, asked);
  return differing(filled, asked);
}

}  // namespace

double worst_error(const System& system, const Contest& contest) {
  const Truth& truth = contest.truth;
  std::vector<double> out(truth.points.size());
  system.singles(truth.points, out);
  double worst = 0;
  for (std::size_t i = 0; i < out.size(); ++i) {
    const double error = std::abs(std::abs(out[i]) - std::abs(truth.distances[i])) / contest.course.diagonal;
    worst = std::max(worst, std::isnan(error) ? std::numeric_limits<double>::infinity() : error);
  }
  return worst;
}

std::size_t count_different(const System& system, const Contest& contest) {
  const Truth& truth = contest.truth;
  std::vector<double> out(truth.points.size());
  system.singles(truth.points, out);
  std::size_t count = differing(out, truth.distances);
  system.batch(truth.points, out, 1);
  count += differing(out, truth.distances);
  return count + differing_in_slab(system, contest.course.grid_peers[1]);
}

}  // namespace cdfr::bench
