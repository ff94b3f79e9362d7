#include "field/deepest.h"

#include <vector>

#include "core/parallel.h"
#include "field/deepest_search.h"
#include "field/leaves.h"

namespace cdfr {

Result<Deepest> deepest_point(const FieldData& field, double error, Progress& progress) {
  DeepestSearch search(field, {error}, progress);
  progress.phase(0, 0.5, static_cast<double>(field.tree.block_count()));
  std::vector<std::vector<DeepestSearch::Looked>> looked(field.tree.block_count());
  for_chunks(looked.size(), 1, [&](std::size_t i, std::size_t) {
    const Block block = field.tree.block(i);
    for_each_leaf(block, [&](const Cell& cell, std::uint32_t number) {
      if (block.leaves[number].side() == Side::outside || !progress.poll()) return;
      const Lattice& lattice = field.tree.lattice;
      looked[i].push_back(search.look({lattice.box(cell).lo, lattice.size(cell.level)}));
    });
    progress.step();
  });
  std::vector<DeepestSearch::Looked> leaves;
  for (std::vector<DeepestSearch::Looked>& block : looked) {
    leaves.insert(leaves.end(), block.begin(), block.end());
    block = {};
  }
  const Deepest deepest = search.run(leaves);
  if (field.failed()) return field.status().error();
  if (progress.cancelled()) return Progress::error();
  return deepest;
}

}  // namespace cdfr
