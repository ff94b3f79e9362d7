/// In which order the points of a batch are answered best.
#pragma once

#include <cstdint>
#include <vector>

#include "cdfr/core/points.h"
#include "field/field_data.h"

namespace cdfr {

/// Numbers, from 0 on, of x[first] .. x[first + count - 1] along a Morton curve through the domain, so that
/// what one point's answer has read serves the next one's, and a mapped file is read block by block. Points
/// beyond the domain come last. Precondition: count <= 2^32. O(count log count). Runs in the caller's task
/// arena.
std::vector<std::uint32_t> along_curve(const FieldData& field, const Points& x, std::size_t first,
                                       std::size_t count);

}  // namespace cdfr
