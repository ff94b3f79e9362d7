/// Shells: sheets of triangles that meet at their shared edges and touch no others. All of a shell has the
/// same winding number just off its front, and one more just behind it, if the mesh is balanced.
#pragma once

#include <cstdint>
#include <span>

#include "mesh/examine.h"

namespace cdfr {

/// Fills in plain_edges and plain_vertices, and for a balanced mesh the sides of each triangle and
/// turned_shells. `touching` is self_contacts' by slot. O(n log n) and one count of crossings a shell. Runs
/// in the caller's arena.
void find_shells(Examined& mesh, std::span<const std::uint32_t> first_twins,
                 std::span<const std::uint8_t> touching, const Scratch* scratch = nullptr);

}  // namespace cdfr
