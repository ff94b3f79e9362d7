/// A cube of edge h that a surface of area A crosses holds 2/3 h^2 of it in the mean, since the surface
/// crosses 3/2 A/h^2 cubes if it has no preferred direction. So if n points fall into c cubes of a grid,
/// their spacing s follows from (n/c) s^2 = 2/3 h^2. The grid must be coarse enough that most cubes hold
/// several points, and fine enough that the surface is flat in one: the finest level with four points a cube.
#include "render/spacing.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

#include "geometry/box_distance.h"
#include "octree/key.h"

namespace cdfr {
namespace {

constexpr int levels = deepest_level + virtual_levels;
constexpr std::uint64_t points_a_cube = 4;

std::vector<std::uint64_t> sorted_keys(std::span<const ContourPoint> points, const Box& box, double side) {
  const auto step_of = [side](double coordinate, double start) {
    const double step = (coordinate - start) / side * (1 << levels);
    return static_cast<std::uint32_t>(std::clamp(step, 0.0, double((1 << levels) - 1)));
  };
  std::vector<std::uint64_t> keys;
  keys.reserve(points.size());
  for (const ContourPoint& point : points) {
    const Vec3 p = point.position;
    keys.push_back(
        key_of({deepest_level, {step_of(p.x, box.lo.x), step_of(p.y, box.lo.y), step_of(p.z, box.lo.z)}}));
  }
  std::sort(keys.begin(), keys.end());
  return keys;
}

}  // namespace

double spacing_on_surface(std::span<const ContourPoint> points, const Box& box) {
  const double side = longest_side(box);
  if (points.empty() || !(side > 0)) return 0;
  const auto keys = sorted_keys(points, box, side);
  // Two neighbours in Morton order are in different cubes up to the coarsest level at which their keys
  // differ.
  std::array<std::uint64_t, levels> first_differences{};
  for (std::size_t i = 1; i < keys.size(); ++i) {
    if (keys[i] == keys[i - 1]) continue;
    const int highest_bit = 63 - std::countl_zero(keys[i] ^ keys[i - 1]);
    ++first_differences[static_cast<std::size_t>(highest_bit / 3)];
  }
  std::uint64_t cubes = 1;
  double spacing = 0;
  double edge = side;
  for (int level = levels - 1; level >= 0; --level) {
    cubes += first_differences[static_cast<std::size_t>(level)];
    edge /= 2;
    if (cubes * points_a_cube > points.size()) break;
    spacing = edge * std::sqrt(2.0 / 3 * static_cast<double>(cubes) / static_cast<double>(points.size()));
  }
  return spacing;
}

}  // namespace cdfr
