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

/// What the leaves may add up to, unless the gain test is off (BuildOptions::gain). With lists of m
/// triangles parts have 1000 to 2000 m^-1.5 leaves a triangle (list_length.cpp). Where many walls are equally
/// far there would be several times as many, at twice the memory, and queries would take as long.
inline constexpr double leaves_in_all = 1U << 11;
inline constexpr double leaves_a_triangle = 1700;  ///< times m^-1.5

/// Leaves come out as `surface` where the surface may touch the closed cell, else as `undecided`: the field
/// sets sides. Runs in the caller's task arena; blocks in parallel. If cancelled, what comes back is
/// incomplete. O(output) but for the levels above the blocks.
Octree build_octree(SearchSpace space, const Lattice& lattice, const BuildOptions& options,
                    Progress& progress);

}  // namespace cdfr
