/// A walk over all leaves of a block in Morton order.
#pragma once

#include <cstdint>
#include <vector>

#include "octree/blocks.h"

namespace cdfr {

/// visit(cell, leaf number) for each leaf.
template <class Visit>
void for_each_leaf(const Block& block, Visit visit) {
  struct Pending {
    Cell cell;
    std::uint32_t node;
  };
  std::vector<Pending> stack{{cell_of(block.key), 0}};
  std::size_t left = block.nodes.size();  // of a forged file's nodes some might be met again and again
  while (!stack.empty() && left-- > 0) {
    const Pending at = stack.back();
    stack.pop_back();
    const TreeNode node = block.nodes[at.node];
    if (node.is_leaf()) {
      visit(at.cell, node.leaf_number());
      continue;
    }
    for (int child = 8; child-- > 0;) {
      stack.push_back({child_of(at.cell, child), node.first_child() + static_cast<std::uint32_t>(child)});
    }
  }
}

}  // namespace cdfr
