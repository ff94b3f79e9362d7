#include "contour/leaf_descent.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "field/query.h"

namespace cdfr {
namespace {

/// Cubes of final size along one whose final cubes are found by supports.
constexpr double small_side = 4;
/// Below so many roundings the general way is as good, and its errors are smaller.
constexpr double least_tolerance = 1024;

}  // namespace

LeafDescent::Sided LeafDescent::side_in(const Region& region) const noexcept {
  if (field_.sign == Sign::none) return Sided::right;
  if (region.side != Side::inside && region.side != Side::outside) return Sided::open;
  return region.side == level_.other_side() ? Sided::wrong : Sided::right;
}

bool LeafDescent::run(const Region& region) {
  const bool is_too_fine = level_.tolerance < least_tolerance * level_.rounding;
  if (level_.height == 0 || region.list.empty() || is_too_fine) return false;
  // The paper's rule takes centres on the other side as well.
  if (level_.rule == Rule::paper && level_.height < level_.tolerance) return false;
  const Sided sided = side_in(region);
  if (sided == Sided::open && level_.jumps) return false;
  if (sided == Sided::wrong) return true;
  const Vec3 middle = region.cube.centre();
  if (!triangles_.fill(region.list, middle, 2 * region.cube.half_diagonal())) return false;
  region_ = {region.cube, middle, final_size(level_, region.cube.size),
             triangles_.error() + level_.rounding / 4};
  finished_.begin(region_);
  std::array<std::uint16_t, LeafTriangles::most> numbers;
  std::iota(numbers.begin(), numbers.end(), std::uint16_t{0});
  siblings_[0].cubes[0] = region.cube;
  siblings_[0].count = 1;
  descend(0, {numbers.data(), triangles_.frames().size()}, sided);
  finished_.end();
  return true;
}

/// A cube that no triangle enters is on one side.
LeafDescent::Sided LeafDescent::side_of(const Cube& cube, double distance) noexcept {
  if (!(distance > cube.half_diagonal() + region_.error)) return Sided::open;
  ++counts_.evaluations;
  return level_.on_side(signed_distance(field_, cube.centre())) ? Sided::right : Sided::wrong;
}

void LeafDescent::find_supports_of(Siblings& cubes, FrameNumbers numbers) {
  centres_.count = 0;
  for (std::size_t i = 0; i < cubes.count; ++i) centres_.add(from_middle(cubes.cubes[i].centre()));
  const double half = grown_half(cubes.cubes[0].size);
  find_supports(triangles_.frames(), numbers, centres_, half, region_.error, cubes.supports.data());
  counts_.evaluations += cubes.count;
}

/// Into the siblings of that depth, all of them in a cube that these numbers may be closest in.
void LeafDescent::descend(std::size_t depth, FrameNumbers numbers, Sided sided) {
  Siblings& cubes = siblings_[depth];
  if (cubes.supports.size() < numbers.size()) cubes.supports.resize(numbers.size());
  find_supports_of(cubes, numbers);
  for (std::size_t child = 0; child < cubes.count; ++child) {
    double distance = cubes.supports[0].distance[child];
    for (std::size_t n = 1; n < numbers.size(); ++n)
      distance = std::min(distance, cubes.supports[n].distance[child]);
    const Cube& cube = cubes.cubes[child];
    if (std::fabs(distance - level_.height) > level_.reach(cube.half_diagonal()) + region_.error) continue;
    const Sided own = sided == Sided::open ? side_of(cube, distance) : sided;
    if (own != Sided::wrong) enter(depth, child, numbers, own);
  }
}

/// A cube that passes.
void LeafDescent::enter(std::size_t depth, std::size_t child, FrameNumbers numbers, Sided sided) {
  const Siblings& cubes = siblings_[depth];
  const Cube& cube = cubes.cubes[child];
  if (sided == Sided::right && cube.size <= small_side * region_.final_size)
    return finish(cubes, child, numbers);
  if (cube.size <= region_.final_size) return single_.finish(cube);
  std::array<std::uint16_t, LeafTriangles::most> kept;
  std::size_t count = 0;
  for (std::size_t n = 0; n < numbers.size(); ++n) {
    kept[count] = numbers[n];
    count += cubes.supports[n].is_near >> child & 1U;
  }
  Siblings& octants = siblings_[depth + 1];
  octants.count = 8;
  for (int i = 0; i < 8; ++i) octants.cubes[static_cast<std::size_t>(i)] = cube.octant(i);
  descend(depth + 1, {kept.data(), count}, sided);
}

/// A small cube on the contour's side.
void LeafDescent::finish(const Siblings& cubes, std::size_t child, FrameNumbers numbers) {
  const Cube& cube = cubes.cubes[child];
  const Vec3 centre = from_middle(cube.centre());
  std::size_t count = 0, closest = 0;
  double distance = 0;
  for (std::size_t n = 0; n < numbers.size(); ++n) {
    const Support& support = cubes.supports[n];
    if ((support.is_near >> child & 1U) == 0) continue;
    if (count == 0 || support.distance[child] < distance) {
      closest = count;
      distance = support.distance[child];
    }
    numbers_[count] = numbers[n];
    supports_[count++] = support.axis(child, centre);
  }
  std::swap(numbers_[0], numbers_[closest]);
  std::swap(supports_[0], supports_[closest]);
  // Too close to a triangle, supports say nothing; without them all small cubes are measured.
  const double half = grown_half(cube.size);
  const bool has_supports = distance >= half;
  const NearTriangles near{triangles_.frames(),
                           {numbers_.data(), count},
                           {supports_.data(), has_supports ? count : 0},
                           support_slack * region_.error};
  const double size = region_.final_size;
  const double most = has_supports ? level_.reach(Cube{{}, size}.half_diagonal()) + region_.error + near.slack
                                   : std::numeric_limits<double>::infinity();
  const auto along = static_cast<std::size_t>(std::round(cube.size / size));
  find_between(near.supports, {centre, along, size}, std::max(distance, half), level_.height - most,
               level_.height + most, centres_);
  if (centres_.count > 0) finished_.put(centres_, near);
}

}  // namespace cdfr
