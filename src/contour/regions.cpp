#include "contour/regions.h"

#include <algorithm>
#include <cmath>

#include "field/leaves.h"
#include "geometry/box_distance.h"

namespace cdfr {
namespace {

bool may_reach(const Block& block, const LeafRecord& leaf, const Cube& cube, const Level& level,
               double unit) noexcept {
  const double least = block.entries[leaf.first].distance() * unit;
  return least <= level.height + cube.half_diagonal() + level.rounding;
}

/// Walks down from a cube that holds all the contour; what lies in the brick is left to the leaves.
class Beyond {
 public:
  Beyond(const FieldData& field, const Level& level, std::vector<Cube>& found)
      : field_(field), level_(level), domain_(field.tree.lattice.domain()), found_(found) {}

  void walk(const Cube& cube) {
    if (inside_domain(cube)) return;
    const double value = value_at(field_, level_, cube.centre());
    if (std::fabs(value - level_.height) > cube.half_diagonal() + level_.rounding) return;
    if (cube.size <= field_.tree.lattice.edge) {
      found_.push_back(cube);
      return;
    }
    for (int child = 0; child < 8; ++child) walk(cube.octant(child));
  }

 private:
  bool inside_domain(const Cube& cube) const noexcept {
    const Vec3 hi{cube.lo.x + cube.size, cube.lo.y + cube.size, cube.lo.z + cube.size};
    return contains(domain_, cube.lo) && contains(domain_, hi);
  }

  const FieldData& field_;
  const Level& level_;
  Box domain_;
  std::vector<Cube>& found_;
};

/// The smallest power of two of the lattice's cubes, around the brick, that reaches `height` beyond the mesh.
/// Its octants fall on the lattice.
Cube enclosing(const FieldData& field, const Level& level) noexcept {
  const Lattice& lattice = field.tree.lattice;
  const Box& box = field.bounds();
  const double longest = std::max({box.hi.x - box.lo.x, box.hi.y - box.lo.y, box.hi.z - box.lo.z});
  double size = 16 * lattice.edge;
  while (size < 4 * (level.height + longest)) size *= 2;
  const double before = size / 2 - 4 * lattice.edge;
  return {{lattice.origin.x - before, lattice.origin.y - before, lattice.origin.z - before}, size};
}

}  // namespace

Regions regions_of(const FieldData& field, const Level& level) {
  Regions regions;
  const Lattice& lattice = field.tree.lattice;
  for (const Block& block : field.tree.blocks) {
    for_each_leaf(block, [&](const Cell& cell, std::uint32_t number) {
      const Cube cube{lattice.box(cell).lo, lattice.size(cell.level)};
      if (may_reach(block, block.leaves[number], cube, level, lattice.edge)) regions.leaves.push_back(cube);
    });
  }
  const Box domain = lattice.domain();
  const Box& box = field.bounds();
  const double reach = level.side > 0 ? level.height + level.rounding : 0;
  const bool leaves_hold_all = box.lo.x - reach >= domain.lo.x && box.hi.x + reach <= domain.hi.x &&
                               box.lo.y - reach >= domain.lo.y && box.hi.y + reach <= domain.hi.y &&
                               box.lo.z - reach >= domain.lo.z && box.hi.z + reach <= domain.hi.z;
  if (!leaves_hold_all) Beyond(field, level, regions.beyond).walk(enclosing(field, level));
  return regions;
}

}  // namespace cdfr
