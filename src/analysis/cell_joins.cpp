#include "analysis/cell_joins.h"

#include <algorithm>

namespace cdfr {
namespace {

constexpr std::size_t cells_a_poll = 4096;

/// Of sorted numbers, each once.
void make_unique(std::vector<std::uint32_t>& numbers) {
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

}  // namespace

CellJoins join_cells(const CoreRule& rule, std::span<const HeavyCell> cells, const CellIndex& index, Progress& progress) {
  CellJoins joins{DisjointSets(cells.size()), {}};
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (i % cells_a_poll == 0 && !progress.poll()) return joins;
    index.for_each_neighbour(i, [&](std::size_t a, std::size_t b) {
      const Touch touch = touch_of(rule, cells[a], cells[b]);
      if (touch == Touch::certain) joins.cores.join(a, b);
      if (touch != Touch::possible || joins.cores.root(a) == joins.cores.root(b)) return;
      joins.doubts.push_back({static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b)});
    });
  }
  std::erase_if(joins.doubts,
                [&](const Doubt& doubt) { return joins.cores.root(doubt.a) == joins.cores.root(doubt.b); });
  return joins;
}

std::vector<DoubtCluster> doubt_clusters(std::span<const Doubt> doubts,
                                         const std::function<std::uint32_t(std::uint32_t)>& core_of) {
  std::vector<std::uint32_t> loose;
  for (const Doubt& doubt : doubts) {
    for (const std::uint32_t cell : {doubt.a, doubt.b}) {
      if (core_of(cell) == no_index) loose.push_back(cell);
    }
  }
  make_unique(loose);
  const auto place = [&](std::uint32_t cell) {
    return static_cast<std::size_t>(std::lower_bound(loose.begin(), loose.end(), cell) - loose.begin());
  };
  DisjointSets sets(loose.size());
  for (const Doubt& doubt : doubts) {
    if (core_of(doubt.a) == no_index && core_of(doubt.b) == no_index)
      sets.join(place(doubt.a), place(doubt.b));
  }
  std::vector<DoubtCluster> clusters;
  std::vector<std::size_t> number(loose.size());
  for (std::size_t i = 0; i < loose.size(); ++i) {
    const std::size_t root = sets.root(i);
    if (root == i) {
      number[i] = clusters.size();
      clusters.emplace_back();
    }
    clusters[number[root]].cells.push_back(loose[i]);
  }
  const auto touch = [&](std::uint32_t cell, std::uint32_t other) {
    if (core_of(cell) == no_index && core_of(other) != no_index)
      clusters[number[sets.root(place(cell))]].cores.push_back(core_of(other));
  };
  for (const Doubt& doubt : doubts) {
    touch(doubt.a, doubt.b);
    touch(doubt.b, doubt.a);
  }
  for (DoubtCluster& cluster : clusters) make_unique(cluster.cores);
  return clusters;
}

}  // namespace cdfr
