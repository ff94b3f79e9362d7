#include "mesh/twins.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace cdfr {

Large<std::uint32_t> first_twins(const Topology& topology, const Scratch* scratch) {
  Large<std::uint32_t> first(topology.triangles.size(), scratch);
  std::iota(first.begin(), first.end(), 0U);
  Large<std::pair<Triangle, std::uint32_t>> sorted(scratch);
  sorted.reserve(first.size());
  for (const std::uint32_t t : first) {
    if (topology.collapsed(t)) continue;
    Triangle corners = topology.triangles[t];
    std::sort(corners.begin(), corners.end());
    sorted.emplace_back(corners, t);
  }
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    if (sorted[i].first == sorted[i - 1].first) first[sorted[i].second] = first[sorted[i - 1].second];
  }
  return first;
}

}  // namespace cdfr
