#include "analysis/depth_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "analysis/ascent.h"
#include "core/parallel.h"
#include "core/vector.h"
#include "field/query.h"
#include "geometry/cube.h"
#include "mesh/disjoint_sets.h"

namespace cdfr {
namespace {

constexpr std::size_t none = CriticalCells::none;
constexpr std::size_t cells_a_chunk = 256;
constexpr double straight_down = 0.9;

/// Calls visit(neighbour) for each cell of the lattice that shares a side with it.
template <class Visit>
void for_each_beside(const Lattice& lattice, const Cell& cell, Visit visit) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::uint32_t end = lattice.bricks[axis] << cell.level;
    Cell beside = cell;
    if (cell.place[axis] > 0) {
      beside.place[axis] = cell.place[axis] - 1;
      visit(beside);
    }
    if (cell.place[axis] + 1 < end) {
      beside.place[axis] = cell.place[axis] + 1;
      visit(beside);
    }
  }
}

/// Keys of the cells beside critical ones, ascending, each once.
std::vector<std::uint64_t> border_of(const Lattice& lattice, const CriticalCells& critical) {
  std::vector<std::uint64_t> border;
  for (const CriticalCell& cell : critical.cells) {
    for_each_beside(lattice, cell_of(cell.key), [&](const Cell& beside) {
      if (critical.find(key_of(beside)) == none) border.push_back(key_of(beside));
    });
  }
  std::sort(border.begin(), border.end());
  border.erase(std::unique(border.begin(), border.end()), border.end());
  return border;
}

/// The flood: cells come deepest first. Each begins as a peak of its own.
class Flood {
 public:
  Flood(const CriticalCells& critical, std::span<const DepthLink> links)
      : critical_(critical),
        links_(links),
        sets_(critical.cells.size()),
        settled_(critical.cells.size()),
        leader_(critical.cells.size()),
        fed_(critical.cells.size()),
        peaks_(critical.cells.size()) {
    std::iota(leader_.begin(), leader_.end(), std::size_t{0});
    for (std::size_t i = 0; i < peaks_.size(); ++i) peaks_[i].cell = i;
  }

  std::vector<DepthPeak> run() {
    std::vector<std::size_t> cells(critical_.cells.size()), links(links_.size());
    std::iota(cells.begin(), cells.end(), std::size_t{0});
    std::iota(links.begin(), links.end(), std::size_t{0});
    std::sort(cells.begin(), cells.end(), [&](std::size_t a, std::size_t b) { return comes_before(a, b); });
    std::stable_sort(links.begin(), links.end(),
                     [&](std::size_t a, std::size_t b) { return links_[a].depth > links_[b].depth; });
    auto link = links.begin();
    for (const std::size_t cell : cells) {
      for (; link != links.end() && links_[*link].depth > depth(cell); ++link) follow(links_[*link]);
      settle(cell);
    }
    for (; link != links.end(); ++link) follow(links_[*link]);
    return std::move(peaks_);
  }

 private:
  double depth(std::size_t cell) const noexcept { return critical_.cells[cell].depth; }
  bool comes_before(std::size_t a, std::size_t b) const noexcept {
    return depth(a) != depth(b) ? depth(a) > depth(b) : a < b;
  }

  void settle(std::size_t cell) {
    settled_[cell] = 1;
    if (critical_.cells[cell].touched) feed(cell, cell);
    for_each_touching(critical_, cell_of(critical_.cells[cell].key), [&](std::size_t beside) {
      if (settled_[beside] != 0) join(cell, beside, cell);
    });
  }

  /// Both ends are at least as deep as the link, hence settled before.
  void follow(const DepthLink& link) {
    join(link.from, link.to, comes_before(link.from, link.to) ? link.to : link.from);
  }

  void feed(std::size_t root, std::size_t neck) noexcept {
    fed_[root] = 1;
    peaks_[leader_[root]].feed = neck;
  }

  void join(std::size_t a, std::size_t b, std::size_t neck) noexcept {
    a = sets_.root(a);
    b = sets_.root(b);
    if (a == b) return;
    if (fed_[a] != fed_[b]) feed(fed_[a] != 0 ? b : a, neck);
    std::size_t elder = leader_[a], younger = leader_[b];
    if (comes_before(younger, elder)) std::swap(elder, younger);
    peaks_[younger].neck = neck;
    peaks_[younger].elder = elder;
    const std::uint8_t fed = fed_[a];
    sets_.join(a, b);
    a = sets_.root(a);
    leader_[a] = elder;
    fed_[a] = fed;
  }

  const CriticalCells& critical_;
  std::span<const DepthLink> links_;
  DisjointSets sets_;
  std::vector<std::uint8_t> settled_;
  std::vector<std::size_t> leader_;  ///< by root: the cell of the component's deepest peak
  std::vector<std::uint8_t> fed_;    ///< by root
  std::vector<DepthPeak> peaks_;     ///< by cell
};

/// A peak without a feed of its own has that of the component that it went into.
void hand_down_feeds(std::vector<DepthPeak>& peaks, const CriticalCells& critical) {
  std::vector<std::size_t> order(peaks.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto depth = [&](std::size_t i) { return critical.cells[i].depth; };
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return depth(a) != depth(b) ? depth(a) > depth(b) : a < b; });
  for (const std::size_t i : order) {
    DepthPeak& peak = peaks[i];
    if (peak.feed == none && peak.elder != none) peak.feed = peaks[peak.elder].feed;
  }
}

/// From the centre of a cell that is not critical, for those critical ones beside it that do not lie straight
/// above: the depth has slope 1 at most, so where it falls by nearly a cell's edge from one to the other the
/// way up leads back.
void climb_from(const FieldData& field, const CriticalCells& critical, const Cell& cell, double floor,
                Ascent& ascent, Progress& progress, std::vector<DepthLink>& links) {
  const Vec3 centre = field.tree.lattice.centre(cell);
  const double depth = -signed_distance(field, centre);
  if (!(depth > floor)) return;
  std::vector<std::size_t> starts;
  for_each_beside(field.tree.lattice, cell, [&](const Cell& beside) {
    const std::size_t number = critical.find(key_of(beside));
    if (number != none && critical.cells[number].depth - depth < straight_down * critical.size)
      starts.push_back(number);
  });
  if (starts.empty()) return;
  const std::size_t top = ascent.climb(to_eigen(centre), depth, progress);
  if (top == none) return;
  for (const std::size_t number : starts) {
    const double least = std::min({depth, critical.cells[number].depth, critical.cells[top].depth});
    if (number != top) links.push_back({number, top, least});
  }
}

}  // namespace

std::vector<DepthLink> links_up(const FieldData& field, const CriticalCells& critical, double floor,
                                Progress& progress) {
  const Lattice& lattice = field.tree.lattice;
  const std::vector<std::uint64_t> border = border_of(lattice, critical);
  std::vector<std::vector<DepthLink>> found((border.size() + cells_a_chunk - 1) / cells_a_chunk);
  progress.phase(0.5, 0.8, static_cast<double>(found.size()));
  for_chunks(border.size(), cells_a_chunk, [&](std::size_t first, std::size_t end) {
    Ascent ascent(field, critical);
    for (std::size_t i = first; i < end && progress.poll(); ++i) {
      climb_from(field, critical, cell_of(border[i]), floor, ascent, progress, found[first / cells_a_chunk]);
    }
    progress.step();
  });
  std::vector<DepthLink> links;
  for (const std::vector<DepthLink>& part : found) links.insert(links.end(), part.begin(), part.end());
  return links;
}

std::vector<DepthPeak> depth_tree(const CriticalCells& critical, std::span<const DepthLink> links,
                                  double prominence) {
  std::vector<DepthPeak> peaks = Flood(critical, links).run();
  hand_down_feeds(peaks, critical);
  const auto depth = [&](std::size_t cell) { return critical.cells[cell].depth; };
  // The elder of a prominent peak is more prominent, so that no name is lost here.
  std::erase_if(peaks, [&](const DepthPeak& peak) {
    const double neck = peak.neck == none ? 0 : depth(peak.neck);
    return !(depth(peak.cell) - neck > prominence);
  });
  std::sort(peaks.begin(), peaks.end(), [&](const DepthPeak& a, const DepthPeak& b) {
    return depth(a.cell) != depth(b.cell) ? depth(a.cell) > depth(b.cell) : a.cell < b.cell;
  });
  return peaks;
}

}  // namespace cdfr
