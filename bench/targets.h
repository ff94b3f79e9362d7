/// What this project wants to reach against its peers, and how far it is.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "rounds.h"

namespace cdfr::bench {

/// Queries that are asked from the mesh on, build included: workloads "total1" and so on.
inline constexpr std::size_t total_queries[] = {1, 1000, 100'000};

struct Target {
  std::string what;
  bool at_least;  ///< else at most
  double wanted;
  double measured;  ///< NaN if nothing was measured that could tell

  bool met() const noexcept { return at_least ? measured >= wanted : measured <= wanted; }
};

std::vector<Target> targets(const std::vector<Sheet>& sheets);

}  // namespace cdfr::bench
