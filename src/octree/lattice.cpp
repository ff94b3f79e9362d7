#include "octree/lattice.h"

#include <algorithm>
#include <cmath>

#include "geometry/box_distance.h"
#include "geometry/query_range.h"

namespace cdfr {
namespace {

/// Largest multiple of `step`, a power of two, that is at most x.
double floor_to(double x, double step) noexcept { return std::floor(x / step) * step; }

/// Tries cubes of that edge, the origin on a multiple of a quarter of it. False if more than eight are needed
/// in a row.
bool fits(const Box& box, double edge, Lattice& lattice) noexcept {
  lattice.edge = edge;
  const double step = edge / 4;
  lattice.origin = {floor_to(box.lo.x, step), floor_to(box.lo.y, step), floor_to(box.lo.z, step)};
  const double wanted[3] = {box.hi.x - lattice.origin.x, box.hi.y - lattice.origin.y,
                            box.hi.z - lattice.origin.z};
  for (int axis = 0; axis < 3; ++axis) {
    const double count = std::max(std::ceil(wanted[axis] / edge), 1.0);
    if (!(count <= 8)) return false;
    lattice.bricks[axis] = static_cast<std::uint32_t>(count);
  }
  const Box domain = lattice.domain();
  return domain.lo.x <= box.lo.x && domain.hi.x >= box.hi.x && domain.lo.y <= box.lo.y &&
         domain.hi.y >= box.hi.y && domain.lo.z <= box.lo.z && domain.hi.z >= box.hi.z;
}

}  // namespace

double Lattice::size(int level) const noexcept { return std::ldexp(edge, -level); }

Box Lattice::box(const Cell& cell) const noexcept {
  const double s = size(cell.level);
  const Vec3 lo{origin.x + cell.place[0] * s, origin.y + cell.place[1] * s, origin.z + cell.place[2] * s};
  return {lo, {lo.x + s, lo.y + s, lo.z + s}};
}

Vec3 Lattice::centre(const Cell& cell) const noexcept {
  const Box b = box(cell);
  const double half = size(cell.level) / 2;
  return {b.lo.x + half, b.lo.y + half, b.lo.z + half};
}

Box Lattice::domain() const noexcept {
  return {origin, {origin.x + bricks[0] * edge, origin.y + bricks[1] * edge, origin.z + bricks[2] * edge}};
}

bool Lattice::meets_brick(const Cell& cell) const noexcept {
  for (int axis = 0; axis < 3; ++axis) {
    const std::uint32_t first =
        cell.level < 0 ? cell.place[axis] << -cell.level : cell.place[axis] >> cell.level;
    if (first >= bricks[axis]) return false;
  }
  return true;
}

double Lattice::grown() const noexcept {
  const Box d = domain();
  const double largest = std::max(largest_magnitude(d.lo), largest_magnitude(d.hi));
  return 4 * std::ldexp(1.0, std::ilogb(largest) - 52);
}

Lattice lattice_for(const Box& mesh, double margin) noexcept {
  const double longest = longest_side(mesh);
  const double largest = std::max(largest_magnitude(mesh.lo), largest_magnitude(mesh.hi));
  const double grow = margin * longest;
  const Box box{{mesh.lo.x - grow, mesh.lo.y - grow, mesh.lo.z - grow},
                {mesh.hi.x + grow, mesh.hi.y + grow, mesh.hi.z + grow}};
  // The mesh may be one point, at the origin even: then any edge does that keeps corners exact.
  double least = std::max({longest * (1 + 2 * margin) / 8, largest * 0x1p-34, smallest_coordinate});
  double edge = std::ldexp(1.0, std::ilogb(least));
  Lattice lattice;
  while (!fits(box, edge, lattice)) edge *= 2;
  return lattice;
}

}  // namespace cdfr
