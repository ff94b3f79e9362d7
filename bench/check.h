/// Are the answers right?
#pragma once

#include <cstddef>

#include "contest.h"

namespace cdfr::bench {

struct Check {
  std::size_t points = 0;
  /// Answers that are not, bit for bit, brute force's, from single calls or from the batch; and points of a
  /// plane of the grid that are not what a single call says. Means something for signed distances only.
  std::size_t different = 0;
  double worst_error = 0;  ///< of the unsigned distance, as a share of the diagonal
};

Check check(const System& system, const Contest& contest);

}  // namespace cdfr::bench
