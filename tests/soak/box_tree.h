/// A tree of boxes that tells which of them meet a box.
#pragma once

#include <cstdint>
#include <vector>

#include "cdfr/core/types.h"

namespace cdfr::soak {

inline bool meet(const Box& a, const Box& b) noexcept {
  return a.lo.x <= b.hi.x && b.lo.x <= a.hi.x && a.lo.y <= b.hi.y && b.lo.y <= a.hi.y && a.lo.z <= b.hi.z &&
         b.lo.z <= a.hi.z;
}

class BoxTree {
 public:
  explicit BoxTree(std::vector<Box> boxes);

  const Box& box(std::uint32_t number) const noexcept { return boxes_[number]; }

  /// Calls visit(number) for every box that meets `query`, until it returns false.
  template <class Visit>
  void over(const Box& query, Visit visit) const {
    std::uint32_t stack[64];  // the tree is balanced: deeper than 32 it cannot be
    int size = 0;
    if (!nodes_.empty()) stack[size++] = 0;
    while (size > 0) {
      const Node& node = nodes_[stack[--size]];
      if (!meet(node.box, query)) continue;
      if (node.count == 0) {
        stack[size++] = node.first;
        stack[size++] = node.first + 1;
        continue;
      }
      for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
        if (meet(boxes_[order_[i]], query) && !visit(order_[i])) return;
      }
    }
  }

 private:
  struct Node {
    Box box;
    std::uint32_t first = 0;  ///< of two child nodes, or in order_ if count > 0
    std::uint32_t count = 0;
  };
  void split(std::uint32_t node, std::uint32_t first, std::uint32_t count);

  std::vector<Box> boxes_;
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
};

}  // namespace cdfr::soak
