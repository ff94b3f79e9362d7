#include "field/locate.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace cdfr {
namespace {

/// Place of x on the deepest level's lattice. x - origin rounds to nearest and so may reach the next lattice
/// point from below by at most half an ulp: cells are complete beyond that (Lattice::grown). Past the last
/// cell there is none: x is in the brick.
std::uint32_t place_on(double x, double origin, double deepest_edge, std::uint32_t bricks) noexcept {
  return std::min(static_cast<std::uint32_t>((x - origin) / deepest_edge), (bricks << deepest_level) - 1);
}

}  // namespace

std::optional<Located> locate(const Octree& tree, const Vec3& p) noexcept {
  const Lattice& lattice = tree.lattice;
  const Box domain = lattice.domain();
  const bool within = p.x >= domain.lo.x && p.x < domain.hi.x && p.y >= domain.lo.y && p.y < domain.hi.y &&
                      p.z >= domain.lo.z && p.z < domain.hi.z;
  if (!within || tree.blocks.empty()) return std::nullopt;
  const double edge = std::ldexp(lattice.edge, -deepest_level);
  const std::array<std::uint32_t, 3> place{place_on(p.x, lattice.origin.x, edge, lattice.bricks[0]),
                                           place_on(p.y, lattice.origin.y, edge, lattice.bricks[1]),
                                           place_on(p.z, lattice.origin.z, edge, lattice.bricks[2])};
  int bit = deepest_level + virtual_levels - 1;
  const auto child = [&]() noexcept {
    const std::uint32_t c =
        (place[0] >> bit & 1U) | (place[1] >> bit & 1U) << 1 | (place[2] >> bit & 1U) << 2;
    --bit;
    return c;
  };
  TreeNode node = tree.top[0];
  while (!node.is_leaf()) node = tree.top[node.first_child() + child()];
  if (node.leaf_number() == Octree::no_block) return std::nullopt;
  Located found;
  found.block = &tree.blocks[node.leaf_number()];
  node = found.block->nodes[0];
  while (!node.is_leaf()) node = found.block->nodes[node.first_child() + child()];
  found.leaf = &found.block->leaves[node.leaf_number()];
  const int up = bit + 1;
  found.cell = {deepest_level - up, {place[0] >> up, place[1] >> up, place[2] >> up}};
  return found;
}

}  // namespace cdfr
