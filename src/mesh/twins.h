/// Triangles that are there more than once.
#pragma once

#include <cstdint>

#include "core/scratch.h"
#include "mesh/topology.h"

namespace cdfr {

/// By triangle number: the lowest number of a triangle with the same three positions in any order, its own if
/// there is none before it. A triangle without three positions is its own. O(n log n).
Large<std::uint32_t> first_twins(const Topology& topology, const Scratch* scratch = nullptr);

}  // namespace cdfr
