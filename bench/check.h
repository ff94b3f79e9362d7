/// Are the answers right?
#pragma once

#include <cstddef>

#include "contest.h"

namespace cdfr::bench {

/// Of the unsigned distance, as a share of the diagonal; infinite if an answer is no number.
double worst_error(const System& system, const Contest& contest);

/// Answers that are not, bit for bit, what they have to be: single calls and the batch say what brute force
/// says, and a slab of the grid what single calls say. For signed distances.
std::size_t count_different(const System& system, const Contest& contest);

}  // namespace cdfr::bench
