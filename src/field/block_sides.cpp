#include "field/block_sides.h"

#include <span>

#include "field/query.h"
#include "field/winding.h"
#include "geometry/box_distance.h"

namespace cdfr {
namespace {

/// From the block down: a cell that its centre's distance shows to be free of triangles answers for all of
/// its leaves.
class SideSetter {
 public:
  SideSetter(const FieldData& field, Block& block, Progress& progress)
      : field_(field), block_(block), leaves_(block.leaves.edit()), progress_(progress) {}

  void run() { visit(cell_of(block_.key), block_.nodes[0]); }

 private:
  void visit(const Cell& cell, TreeNode node) {
    if (!progress_.poll()) return;
    if (node.is_leaf() && block_.leaves[node.leaf_number()].side() == Side::surface) return;
    const Lattice& lattice = field_.tree.lattice;
    const Vec3 centre = lattice.centre(cell);
    const double radius = (diagonal_above(lattice.box(cell)) / 2 + 2 * lattice.grown()) * (1 + 0x1p-50);
    const bool free = node.is_leaf() || unsigned_distance(field_, centre) > radius * (1 + 0x1p-50);
    const Side side = free ? side_of_free_ball(field_, centre, radius) : Side::undecided;
    if (side != Side::undecided) return set_all(node, side);
    if (node.is_leaf()) return;
    for (int child = 0; child < 8; ++child) {
      visit(child_of(cell, child), block_.nodes[node.first_child() + static_cast<std::uint32_t>(child)]);
    }
  }

  void set_all(TreeNode node, Side side) noexcept {
    if (node.is_leaf()) {
      LeafRecord& leaf = leaves_[node.leaf_number()];
      return leaf.set(leaf.count(), side);
    }
    for (std::uint32_t child = 0; child < 8; ++child) set_all(block_.nodes[node.first_child() + child], side);
  }

  const FieldData& field_;
  Block& block_;
  std::span<LeafRecord> leaves_;
  Progress& progress_;
};

}  // namespace

bool sides_are_certain(const FieldData& field) noexcept {
  return field.sign == Sign::winding || (field.sign == Sign::pseudonormal && field.report.embedded());
}

/// Without boundary all of a free ball is where its centre is.
Side side_of_free_ball(const FieldData& field, const Vec3& centre, double radius) noexcept {
  if (!field.winding.empty()) return side_of_ball(field.winding, field.space(), centre, radius);
  return signed_distance(field, centre) < 0 ? Side::inside : Side::outside;
}

void set_sides(const FieldData& field, Block& block, Progress& progress) {
  if (sides_are_certain(field)) SideSetter(field, block, progress).run();
}

}  // namespace cdfr
