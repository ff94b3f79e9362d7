#include "analysis/depth_tree.h"

#include <algorithm>
#include <numeric>

#include "mesh/disjoint_sets.h"

namespace cdfr {
namespace {

constexpr std::size_t none = CriticalCells::none;

/// Each cell begins as a peak of its own.
class Flood {
 public:
  explicit Flood(const CriticalCells& critical)
      : critical_(critical),
        sets_(critical.cells.size()),
        leader_(critical.cells.size()),
        peaks_(critical.cells.size()) {
    std::iota(leader_.begin(), leader_.end(), std::size_t{0});
    for (std::size_t i = 0; i < peaks_.size(); ++i) {
      peaks_[i].cell = i;
      const CriticalCell& cell = critical.cells[i];
      if (cell.touched) feed(peaks_[i], cell.core, cell.depth);
    }
  }

  /// Links come deepest first.
  void follow(const DepthLink& link) {
    const std::size_t a = sets_.root(link.from), b = sets_.root(link.to);
    if (a == b) return;
    DepthPeak *elder = &peaks_[leader_[a]], *younger = &peaks_[leader_[b]];
    if (comes_before(younger->cell, elder->cell)) std::swap(elder, younger);
    if (elder->fed != younger->fed) feed(elder->fed ? *younger : *elder, link.place, link.depth);
    younger->elder = elder->cell;
    younger->neck = link.place;
    younger->neck_depth = link.depth;
    sets_.join(a, b);
    leader_[sets_.root(a)] = elder->cell;
  }

  /// A peak without a feed of its own has that of the component that it went into.
  std::vector<DepthPeak> take() {
    std::vector<std::size_t> order(peaks_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return comes_before(a, b); });
    for (const std::size_t i : order) {
      DepthPeak& peak = peaks_[i];
      if (peak.fed || peak.elder == none) continue;
      const DepthPeak& elder = peaks_[peak.elder];
      if (elder.fed) feed(peak, elder.feed, elder.feed_depth);
    }
    return std::move(peaks_);
  }

 private:
  static void feed(DepthPeak& peak, const Vec3& place, double depth) noexcept {
    peak.fed = true;
    peak.feed = place;
    peak.feed_depth = depth;
  }
  bool comes_before(std::size_t a, std::size_t b) const noexcept {
    const double x = critical_.cells[a].depth, y = critical_.cells[b].depth;
    return x != y ? x > y : a < b;
  }

  const CriticalCells& critical_;
  DisjointSets sets_;
  std::vector<std::size_t> leader_;  ///< by root: the cell of the component's deepest peak
  std::vector<DepthPeak> peaks_;     ///< by cell
};

}  // namespace

std::vector<DepthPeak> depth_tree(const CriticalCells& critical, std::vector<DepthLink> links,
                                  double prominence) {
  std::stable_sort(links.begin(), links.end(),
                   [](const DepthLink& a, const DepthLink& b) { return a.depth > b.depth; });
  Flood flood(critical);
  for (const DepthLink& link : links) flood.follow(link);
  std::vector<DepthPeak> peaks = flood.take();
  // The elder of a prominent peak is more prominent, so that no name is lost here.
  const auto depth = [&](const DepthPeak& peak) { return critical.cells[peak.cell].depth; };
  std::erase_if(peaks, [&](const DepthPeak& peak) { return !(depth(peak) - peak.neck_depth > prominence); });
  std::sort(peaks.begin(), peaks.end(), [&](const DepthPeak& a, const DepthPeak& b) {
    return depth(a) != depth(b) ? depth(a) > depth(b) : a.cell < b.cell;
  });
  return peaks;
}

}  // namespace cdfr
