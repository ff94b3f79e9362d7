#include "analysis/material.h"

#include <algorithm>
#include <cmath>

#include "core/vector.h"
#include "field/block_sides.h"
#include "field/query.h"
#include "geometry/box_distance.h"
#include "geometry/query_range.h"

namespace cdfr {
namespace {

/// From so many levels above the last one on triangles are looked at: before, too many of them are near.
constexpr int blind_levels = 3;
/// Offsets of planes round by less than this share of the way to their triangle: 8 u.
constexpr double plane_share = 0x1p-50;

double volume_of(const Cube& cube) noexcept { return cube.size * cube.size * cube.size; }

double sum_of_sizes(const Vec3& v) noexcept { return std::fabs(v.x) + std::fabs(v.y) + std::fabs(v.z); }

/// By how much a distance may be above its tangent, at that distance from the centre.
double rise(double distance, double half_diagonal) noexcept {
  const double least = distance - half_diagonal;
  return least > 0 ? half_diagonal * half_diagonal / (2 * least) : HUGE_VAL;
}

}  // namespace

/// Feet round by 2^-38 of the way to the farthest vertex (plain_foot.h), and their directions by that over
/// the distance, which where they count is more than half the cube's edge.
MaterialDescent::MaterialDescent(const FieldData& field, const MaterialSearch& search, Progress& progress)
    : field_(field),
      search_(search),
      progress_(progress),
      rounding_(point_rounding(
                    std::max(largest_magnitude(field.bounds().lo), largest_magnitude(field.bounds().hi))) +
                0x1p-38 * field.tree.lattice.reach()) {}

/// `among`: slots of the triangles that can be closest in the cell, or null if nothing is known. `inside`:
/// all of the cell is.
void MaterialDescent::descend(const Cell& cell, const std::vector<std::uint32_t>* among, bool inside) {
  const Cube cube{field_.tree.lattice.box(cell).lo, field_.tree.lattice.size(cell.level)};
  const double radius = cube.half_diagonal() + rounding_;
  double distance = among == nullptr ? unsigned_distance(field_, cube.centre()) : HUGE_VAL;
  const double reach = distance + 2 * radius;
  if (squared_distance_below(cube.centre(), search_.box) > reach * reach) return;
  const bool known =
      (among != nullptr || cell.level + blind_levels >= search_.level) && look(cube, distance, among);
  if (known) {
    for (const NearTriangle& near : near_) distance = std::min(distance, near.foot.distance);
  }
  const std::size_t own = known ? count_marked() : 0;
  if (known && own == 0) return;
  if (!inside && distance > radius) {
    const Side side = side_of_free_ball(field_, cube.centre(), radius);
    if (side == Side::outside) return;
    inside = side == Side::inside;
  }
  const bool is_last = cell.level >= search_.level;
  const Cut found = known ? cut(cube, inside, own == near_.size()) : Cut{{0, volume_of(cube)}, HUGE_VAL};
  if (is_last || found.spread <= search_.flat) {
    found_.sure += found.volume.sure;
    found_.possible += found.volume.possible;
    return;
  }
  if (!progress_.poll()) return;
  std::vector<std::uint32_t> slots;
  if (known) {
    for (const NearTriangle& near : near_) slots.push_back(near.slot);
  }
  for (int child = 0; child < 8; ++child) descend(child_of(cell, child), known ? &slots : nullptr, inside);
}

/// The triangles that can be closest in the cube. False if they are too many.
bool MaterialDescent::look(const Cube& cube, double distance, const std::vector<std::uint32_t>* among) {
  const Eigen::Vector3d centre = to_eigen(cube.centre());
  return among != nullptr ? near_triangles(field_, centre, cube.size, *among, near_)
                          : near_triangles(field_, centre, cube.size, distance, near_);
}

std::size_t MaterialDescent::count_marked() const noexcept {
  return static_cast<std::size_t>(std::count_if(
      near_.begin(), near_.end(), [&](const NearTriangle& near) { return search_.marked[near.slot] != 0; }));
}

/// Has the triangle the outside in front of all of it, and the inside behind?
bool MaterialDescent::is_outward(std::uint32_t slot) const noexcept {
  return field_.report.embedded() || field_.triangles.records[slot].sides == Sides::outward;
}

/// `all` triangles that can be closest are marked.
MaterialDescent::Cut MaterialDescent::cut(const Cube& cube, bool inside, bool all) const noexcept {
  const double volume = volume_of(cube);
  if (inside) return all ? Cut{{volume, volume}, 0} : closer_to_marked(cube);
  const Cut part = inside_by_planes(cube);
  if (all || part.volume.possible == 0) return part;
  return {{0, part.volume.possible}, HUGE_VAL};
}

MaterialDescent::Cut MaterialDescent::inside_by_planes(const Cube& cube) const noexcept {
  const Vec3 centre = cube.centre();
  const double half = cube.size / 2, volume = volume_of(cube);
  const Cut nothing_told{{0, volume}, HUGE_VAL};
  if (!field_.winding.empty()) return nothing_told;
  PlaneRange planes;
  double rounding = 0;
  for (const NearTriangle& near : near_) {
    if (near.foot.distance > cube.half_diagonal() + rounding_) continue;
    const TriangleShape& shape = field_.triangles.shape(near.slot);
    const Vec3 n = rounded(shape.normal), vertex = shape.vertices[0];
    if (!is_outward(near.slot) || n == Vec3{}) return nothing_told;
    const Vec3 way{vertex.x - centre.x, vertex.y - centre.y, vertex.z - centre.z};
    const double offset = n.x * way.x + n.y * way.y + n.z * way.z;
    const double own_rounding = plane_share * (sum_of_sizes(way) + 3 * half);
    if (std::fabs(offset) > half * sum_of_sizes(n) + own_rounding) continue;
    planes.add(offset, {-n.x, -n.y, -n.z});
    rounding = std::max(rounding, own_rounding);
  }
  if (planes.is_empty()) {
    const double whole = signed_distance(field_, centre) < 0 ? volume : 0;
    return {{whole, whole}, 0};
  }
  const double spread = planes.spread(half) + rounding;
  return {volume_above(planes.middle(), spread, half), spread};
}

/// Precondition: all of the cube is inside, and both marked triangles and others are near.
MaterialDescent::Cut MaterialDescent::closer_to_marked(const Cube& cube) const noexcept {
  const double half = cube.size / 2, half_diagonal = cube.half_diagonal();
  PlaneRange own, others;
  for (const NearTriangle& near : near_) {
    PlaneRange& range = search_.marked[near.slot] != 0 ? own : others;
    range.add(near.foot.distance, from_eigen(near.foot.gradient));
  }
  const double rises =
      std::max(rise(own.least_offset(), half_diagonal), rise(others.least_offset(), half_diagonal));
  const double spread = own.spread(half) + others.spread(half) + rises + 4 * rounding_;
  const LinearFunction from = own.middle(), to = others.middle();
  LinearFunction difference;
  for (std::size_t i = 0; i < 4; ++i) difference[i] = to[i] - from[i];
  return {volume_above(difference, spread, half), spread};
}

}  // namespace cdfr
