/// The octree over a mesh: cut into blocks, then level by level inside each block.
#pragma once

#include <cstdint>

#include "cdfr/octree/options.h"
#include "core/progress.h"
#include "octree/blocks.h"
#include "octree/search.h"

namespace cdfr {

/// Cells of level 0 and deeper with at most this many triangles in their list become roots of blocks; so do
/// all of level block_deepest.
inline constexpr std::uint64_t block_triangles = 1U << 16;
inline constexpr int block_deepest = 6;

/// What the leaves may add up to, unless the gain test is off (BuildOptions::gain). Parts need 2 to 8 a
/// triangle.
inline constexpr std::uint64_t leaves_in_all = 1U << 16;
inline constexpr std::uint64_t leaves_a_triangle = 32;

/// Leaves come out as `surface` where the surface may touch the closed cell, else as `undecided`: the field
/// sets sides. Runs in the caller's task arena; blocks in parallel. If cancelled, what comes back is
/// incomplete. O(output) but for the levels above the blocks.
Octree build_octree(SearchSpace space, const Lattice& lattice, const BuildOptions& options,
                    Progress& progress);

}  // namespace cdfr
