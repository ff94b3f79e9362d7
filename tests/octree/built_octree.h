/// An octree over a mesh, without a field.
#pragma once

#include <utility>
#include <vector>

#include "core/progress.h"
#include "octree/build.h"

namespace cdfr::test {

inline Octree build_octree(SearchSpace space, const Lattice& lattice, const BuildOptions& options) {
  const Run run;
  Progress progress(run);
  BlockCut cut(space, lattice, options, progress);
  Octree tree = cut.octree();
  std::vector<Block> blocks;
  for (std::size_t i = 0; i < cut.size(); ++i) {
    BuiltBlock built = cut.build(i);
    add_levels(tree.levels, built.levels);
    blocks.push_back(std::move(built.block));
  }
  join(tree, std::move(blocks));
  return tree;
}

}  // namespace cdfr::test
