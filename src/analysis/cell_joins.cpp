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

/// Roots of those of the doubts' cells that have no core.
std::vector<std::uint32_t> loose_cells(std::span<const Doubt> doubts, CellJoins& joins) {
  std::vector<std::uint32_t> loose;
  for (const Doubt& doubt : doubts) {
    for (const std::uint32_t cell : {doubt.a, doubt.b}) {
      if (joins.core_of(cell) == no_index) loose.push_back(joins.root(cell));
    }
  }
  make_unique(loose);
  return loose;
}

/// Breadth first from the cores over the cells in doubt.
class Territories {
 public:
  Territories(std::span<const Doubt> doubts, CellJoins& joins)
      : joins_(joins), loose_(loose_cells(doubts, joins)), label_(loose_.size(), no_index) {
    for (const Doubt& doubt : doubts) {
      add(doubt.a, doubt.b);
      add(doubt.b, doubt.a);
    }
    std::sort(links_.begin(), links_.end());
    std::vector<std::uint32_t> border = std::move(first_);
    for (std::size_t next = 0; next < border.size(); ++next) {
      auto link = std::lower_bound(links_.begin(), links_.end(), Link{border[next], 0});
      for (; link != links_.end() && link->from == border[next]; ++link) {
        if (label_[link->to] != no_index) continue;
        label_[link->to] = label_[border[next]];
        border.push_back(link->to);
      }
    }
  }

  /// no_index beyond all cores.
  std::uint32_t of(std::uint32_t cell) const {
    const std::uint32_t core = joins_.core_of(cell);
    return core != no_index ? core : label_[place(cell)];
  }

 private:
  /// Places among the loose cells.
  struct Link {
    std::uint32_t from, to;
    friend auto operator<=>(const Link&, const Link&) = default;
  };

  std::uint32_t place(std::uint32_t cell) const {
    const auto found = std::lower_bound(loose_.begin(), loose_.end(), joins_.root(cell));
    return static_cast<std::uint32_t>(found - loose_.begin());
  }
  void add(std::uint32_t from, std::uint32_t to) {
    if (joins_.core_of(from) != no_index) return;
    const std::uint32_t own = place(from), core = joins_.core_of(to);
    if (core == no_index) return void(links_.push_back({own, place(to)}));
    if (label_[own] == no_index) first_.push_back(own);
    label_[own] = std::min(label_[own], core);
  }

  CellJoins& joins_;
  std::vector<std::uint32_t> loose_, label_, first_;
  std::vector<Link> links_;
};

}  // namespace

CellJoins join_cells(const CoreRule& rule, std::span<const HeavyCell> cells, const CellIndex& index,
                     Progress& progress) {
  CellJoins joins{DisjointSets(cells.size()), {}, {}};
  joins.has_core.reserve(cells.size());
  for (const HeavyCell& cell : cells) joins.has_core.push_back(has_core(rule, cell));
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

std::vector<DoubtCluster> doubt_clusters(std::span<const Doubt> doubts, CellJoins& joins) {
  const std::vector<std::uint32_t> loose = loose_cells(doubts, joins);
  const auto place = [&](std::uint32_t cell) {
    return static_cast<std::size_t>(std::lower_bound(loose.begin(), loose.end(), joins.root(cell)) -
                                    loose.begin());
  };
  DisjointSets sets(loose.size());
  for (const Doubt& doubt : doubts) {
    if (joins.core_of(doubt.a) == no_index && joins.core_of(doubt.b) == no_index)
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
    if (joins.core_of(cell) == no_index && joins.core_of(other) != no_index)
      clusters[number[sets.root(place(cell))]].cores.push_back(joins.core_of(other));
  };
  for (const Doubt& doubt : doubts) {
    touch(doubt.a, doubt.b);
    touch(doubt.b, doubt.a);
  }
  for (DoubtCluster& cluster : clusters) make_unique(cluster.cores);
  return clusters;
}

std::vector<Seam> seams_between(std::span<const Doubt> doubts, CellJoins& joins) {
  const Territories territories(doubts, joins);
  std::vector<Seam> seams;
  for (const Doubt& doubt : doubts) {
    const std::uint32_t a = territories.of(doubt.a), b = territories.of(doubt.b);
    if (a == no_index || b == no_index || a == b) continue;
    seams.push_back({std::min(a, b), std::max(a, b), doubt});
  }
  return seams;
}

}  // namespace cdfr
