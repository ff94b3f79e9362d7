/// From a point to its leaf.
#pragma once

#include <optional>
#include <span>

#include "cdfr/core/types.h"
#include "octree/blocks.h"

namespace cdfr {

struct Located {
  const Block* block = nullptr;
  const LeafRecord* leaf = nullptr;
  Cell cell;

  std::span<const Entry> entries() const noexcept {
    return std::span<const Entry>(block->entries).subspan(leaf->first, leaf->count());
  }
};

/// The leaf whose half-open cell holds p; nothing outside the brick. One load a level.
std::optional<Located> locate(const Octree& tree, const Vec3& p) noexcept;

}  // namespace cdfr
