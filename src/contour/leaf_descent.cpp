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
  Siblings& alone = siblings_[0];
  alone.cubes[0] = region.cube;
  alone.count = 1;
  alone.list.count = triangles_.frames().size();
  alone.list.has_supports = false;
  std::iota(alone.list.numbers.begin(), alone.list.numbers.end(), std::uint16_t{0});
  descend(0, sided);
  finished_.end();
  return true;
}

NearTriangles LeafDescent::near(const List& list) const noexcept {
  return {triangles_.frames(),
          {list.numbers.data(), list.count},
          {list.supports.data(), list.has_supports ? list.count : 0},
          support_slack * region_.error};
}

void LeafDescent::find_supports_of(Siblings& cubes) {
  centres_.count = 0;
  for (std::size_t i = 0; i < cubes.count; ++i) centres_.add(from_middle(cubes.cubes[i].centre()));
  find_supports(near(cubes.list), centres_, grown_half(cubes.cubes[0].size), region_.error, cubes.supports);
  counts_.evaluations += cubes.count;
}

/// Which side that point off the surface is on.
LeafDescent::Sided LeafDescent::side_of(const Vec3& x) noexcept {
  ++counts_.evaluations;
  return level_.on_side(signed_distance(field_, x)) ? Sided::right : Sided::wrong;
}

/// Cubes that no triangle enters are on one side, and octants all on the same one: they have a corner in
/// common.
void LeafDescent::descend(std::size_t depth, Sided sided) {
  Siblings& cubes = siblings_[depth];
  find_supports_of(cubes);
  const double half_diagonal = cubes.cubes[0].half_diagonal();
  const double most = level_.reach(half_diagonal) + region_.error;
  Sided of_clear = sided;
  for (std::size_t child = 0; child < cubes.count; ++child) {
    const double distance = cubes.supports.least[child];
    if (std::fabs(distance - level_.height) > most) continue;
    const bool is_clear = sided != Sided::open || distance > half_diagonal + region_.error;
    if (is_clear && of_clear == Sided::open) of_clear = side_of(cubes.cubes[child].centre());
    const Sided own = is_clear ? of_clear : Sided::open;
    if (own != Sided::wrong) enter(depth, child, own);
  }
}

/// A cube that passes.
void LeafDescent::enter(std::size_t depth, std::size_t child, Sided sided) {
  const Siblings& cubes = siblings_[depth];
  const Cube& cube = cubes.cubes[child];
  if (sided == Sided::right && cube.size <= small_side * region_.final_size) {
    gather(cubes, child, small_);
    return finish(cube, small_);
  }
  if (cube.size <= region_.final_size) return single_.finish(cube);
  Siblings& octants = siblings_[depth + 1];
  gather(cubes, child, octants.list);
  octants.count = 8;
  for (int i = 0; i < 8; ++i) octants.cubes[static_cast<std::size_t>(i)] = cube.octant(i);
  descend(depth + 1, sided);
}

/// The order stays the same but for the first one's, so that ties fall the same way whatever else is in a
/// list.
void LeafDescent::gather(const Siblings& cubes, std::size_t child, List& list) const noexcept {
  const Vec3 centre = from_middle(cubes.cubes[child].centre());
  list.count = 0;
  list.distance = cubes.supports.least[child];
  std::ptrdiff_t closest = -1;
  for (std::size_t n = 0; n < cubes.list.count; ++n) {
    if ((cubes.supports.near[n] >> child & 1U) == 0) continue;
    if (closest < 0 && cubes.supports.of[n].distance[child] == list.distance)
      closest = static_cast<std::ptrdiff_t>(list.count);
    list.numbers[list.count] = cubes.list.numbers[n];
    list.supports[list.count++] = cubes.supports.axis(n, child, centre);
  }
  std::rotate(list.numbers.begin(), list.numbers.begin() + closest, list.numbers.begin() + closest + 1);
  std::rotate(list.supports.begin(), list.supports.begin() + closest, list.supports.begin() + closest + 1);
  list.has_supports = true;
}

/// A small cube on the contour's side. Too close to a triangle supports bound nothing from above, and all
/// small cubes are measured.
void LeafDescent::finish(const Cube& cube, const List& list) {
  NearTriangles near = this->near(list);
  const double size = region_.final_size, half = grown_half(cube.size);
  double most = level_.reach(Cube{{}, size}.half_diagonal()) + region_.error + near.slack;
  if (list.distance < half) {
    near.supports = {};
    most = std::numeric_limits<double>::infinity();
  }
  const auto along = static_cast<std::size_t>(std::round(cube.size / size));
  find_between(near.supports, {from_middle(cube.centre()), along, size}, std::max(list.distance, half),
               level_.height - most, level_.height + most, centres_);
  if (centres_.count > 0) finished_.put(centres_, near);
}

}  // namespace cdfr
