#include "field/domain.h"

#include "field/block_sides.h"
#include "geometry/box_distance.h"

namespace cdfr {

/// Where it is not certain that all of a cell is outside, the cell stays.
LeftOut cells_left_out(const FieldData& field) {
  const auto radius_of = [&field](const Cell& cell) {
    const Lattice& lattice = field.tree.lattice;
    return (diagonal_above(lattice.box(cell)) / 2 + 2 * lattice.grown()) * (1 + 0x1p-50);
  };
  switch (field.options.domain) {
    case Domain::box:
      return {};
    case Domain::band:
      return [&field, radius_of](const Cell& cell, double away, bool) {
        return away - radius_of(cell) > field.options.band;
      };
    case Domain::interior:
      return [&field, radius_of](const Cell& cell, double, bool is_free) {
        return is_free && sides_are_certain(field) &&
               side_of_free_ball(field, field.tree.lattice.centre(cell), radius_of(cell)) == Side::outside;
      };
  }
  return {};
}

bool is_left_out(const FieldData& field, const Block& block, const LeafRecord& leaf) noexcept {
  if (field.options.domain == Domain::box || leaf.count() != 1) return false;
  const Entry& entry = block.entries[leaf.first];
  return entry.number() == 0 && entry.is_group() == field.bvh.nodes[0].is_group() && entry.distance() == 0 &&
         leaf.side() != Side::surface;
}

}  // namespace cdfr
