/// Sets that grow together.
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>

#include "core/scratch.h"

namespace cdfr {

/// The root of a set is its lowest member.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t size, const Scratch* scratch = nullptr) : parent_(size, scratch) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }
  /// A set of one more member, whose number comes back.
  std::size_t add() {
    parent_.push_back(parent_.size());
    return parent_.size() - 1;
  }
  std::size_t root(std::size_t i) noexcept {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::size_t a, std::size_t b) noexcept {
    a = root(a);
    b = root(b);
    if (a != b) parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  Large<std::size_t> parent_;
};

}  // namespace cdfr
