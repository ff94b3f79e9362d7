#include "analysis/material.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "analysis/cut_cube.h"
#include "core/vector.h"
#include "field/block_sides.h"
#include "field/query.h"
#include "geometry/box_distance.h"
#include "geometry/query_range.h"

namespace cdfr {
namespace {

/// Shares of a direction below which a component is left out, and of a cube that its cut is off by, both with
/// room to spare (cut_cube.h).
constexpr double least_share = 0x1p-20, cut_share = 0x1p-27;
/// Offsets of planes round by less than this share of the way to their triangle: 8 u.
constexpr double plane_share = 0x1p-50;

double volume_of(const Cube& cube) noexcept { return cube.size * cube.size * cube.size; }

/// The least and the greatest of the depths below planes, o + w.y as (o, w).
struct PlaneRange {
  std::array<double, 4> least{HUGE_VAL, HUGE_VAL, HUGE_VAL, HUGE_VAL};
  std::array<double, 4> most{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
  double rounding = 0;

  void add(const Vec3& normal, const Vec3& way, double half) noexcept {
    const std::array<double, 4> plane{normal.x * way.x + normal.y * way.y + normal.z * way.z, -normal.x,
                                      -normal.y, -normal.z};
    for (std::size_t i = 0; i < 4; ++i) {
      least[i] = std::min(least[i], plane[i]);
      most[i] = std::max(most[i], plane[i]);
    }
    const double reach = std::fabs(way.x) + std::fabs(way.y) + std::fabs(way.z) + 3 * half;
    rounding = std::max(rounding, plane_share * reach);
  }

  std::array<double, 4> middle() const noexcept {
    std::array<double, 4> plane;
    for (std::size_t i = 0; i < 4; ++i) plane[i] = (least[i] + most[i]) / 2;
    const double largest = std::max({std::fabs(plane[1]), std::fabs(plane[2]), std::fabs(plane[3])});
    for (std::size_t i = 1; i < 4; ++i) {
      if (std::fabs(plane[i]) < least_share * largest) plane[i] = 0;
    }
    return plane;
  }

  double spread(const std::array<double, 4>& plane, double half) const noexcept {
    double sum = rounding;
    for (std::size_t i = 0; i < 4; ++i)
      sum += std::max(most[i] - plane[i], plane[i] - least[i]) * (i == 0 ? 1 : half);
    return sum;
  }
};

}  // namespace

/// Feet round by 2^-38 of the way to the farthest vertex (plain_foot.h).
MaterialDescent::MaterialDescent(const FieldData& field, const MaterialSearch& search, Progress& progress)
    : field_(field),
      search_(search),
      progress_(progress),
      rounding_(point_rounding(std::max(largest_magnitude(field.bounds().lo),
                                        largest_magnitude(field.bounds().hi))) +
                0x1p-38 * field.tree.lattice.reach()) {}

/// `among`: slots of the triangles that can be closest in the cell, or null if nothing is known. `inside`:
/// all of the cell is.
void MaterialDescent::descend(const Cell& cell, const std::vector<std::uint32_t>* among, bool inside) {
  const Cube cube{field_.tree.lattice.box(cell).lo, field_.tree.lattice.size(cell.level)};
  const double radius = cube.half_diagonal() + rounding_;
  double distance = among == nullptr ? unsigned_distance(field_, cube.centre()) : 0;
  const double reach = distance + 2 * radius;
  if (among == nullptr && squared_distance_below(cube.centre(), search_.box) > reach * reach) return;
  const bool known = look(cube, distance, among);
  if (known) {
    distance = HUGE_VAL;
    for (const NearTriangle& near : near_) distance = std::min(distance, near.foot.distance);
  }
  const std::size_t own = known ? count_marked() : 0;
  if (known && own == 0) return;
  const bool all = known && own == near_.size();
  if (!inside && distance > radius) {
    const Side side = side_of_free_ball(field_, cube.centre(), radius);
    if (side == Side::outside) return;
    inside = side == Side::inside;
  }
  const double volume = volume_of(cube);
  if (inside && all) return add({volume, volume});
  const bool is_last = cell.level >= search_.level;
  if (is_last || all) {
    const Inside part = known && !inside ? inside_by_planes(cube) : Inside{{0, volume}, HUGE_VAL};
    if (is_last || part.spread <= search_.flat)
      return add({all ? part.volume.sure : 0, part.volume.possible});
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
  return static_cast<std::size_t>(std::count_if(near_.begin(), near_.end(), [&](const NearTriangle& near) {
    return search_.marked[near.slot] != 0;
  }));
}

/// Has the triangle the outside in front of all of it, and the inside behind?
bool MaterialDescent::is_outward(std::uint32_t slot) const noexcept {
  return field_.report.embedded() || field_.triangles.records[slot].sides == Sides::outward;
}

MaterialDescent::Inside MaterialDescent::inside_by_planes(const Cube& cube) const noexcept {
  const Vec3 centre = cube.centre();
  const double half = cube.size / 2, volume = volume_of(cube);
  PlaneRange planes;
  for (const NearTriangle& near : near_) {
    const TriangleShape& shape = field_.triangles.shape(near.slot);
    const Vec3 normal = rounded(shape.normal), vertex = shape.vertices[0];
    if (!is_outward(near.slot) || normal == Vec3{}) return {{0, volume}, HUGE_VAL};
    planes.add(normal, {vertex.x - centre.x, vertex.y - centre.y, vertex.z - centre.z}, half);
  }
  const std::array<double, 4> plane = planes.middle();
  const double spread = planes.spread(plane, half);
  const Vec3 way{plane[1], plane[2], plane[3]};
  const double sure = cut_cube(way, plane[0] - spread, half).volume - cut_share * volume;
  const double possible = cut_cube(way, plane[0] + spread, half).volume + cut_share * volume;
  return {{std::max(sure, 0.0), std::min(possible, volume)}, spread};
}

}  // namespace cdfr
