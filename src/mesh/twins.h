/// Triangles that are there more than once.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/topology.h"

namespace cdfr {

/// By triangle number: the lowest number of a triangle with the same three positions in any order, its own if
/// there is none before it. A triangle without three positions is its own. O(n log n).
std::vector<std::uint32_t> first_twins(const Topology& topology);

}  // namespace cdfr
