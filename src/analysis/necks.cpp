#include "analysis/necks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>
#include <unordered_set>

#include "analysis/heavy_descent.h"

namespace cdfr {
namespace {

/// A chain of cells in doubt is resolved from its ends, a cell or two a round.
constexpr int most_rounds = 64;
/// Cells that may be halved in one round.
constexpr std::size_t most_halved = std::size_t{1} << 13;
/// Half diagonal of the smallest cells that are halved, in errors.
constexpr double least_halved = 0x1p-8;

/// Cells in doubt, halved on top of the cells that were found first. A number below cells.size() is one of
/// those, the others are halved ones.
class Overlay {
 public:
  Overlay(const FieldData& field, const Threshold& threshold, std::span<const HeavyCell> cells,
          const CellIndex& index, CellJoins& joins, Progress& progress)
      : field_(field),
        progress_(progress),
        threshold_(threshold),
        rule_(threshold, field.tree.lattice),
        cells_(cells),
        index_(index),
        joins_(joins),
        doubts_(joins.doubts),
        least_half_(threshold.error / std::sqrt(3.0) * least_halved / field.tree.lattice.edge) {}

  NeckFindings run() {
    drop_idle_doubts();
    std::vector<std::uint32_t> between;
    for (int round = 0; round < most_rounds && progress_.poll(); ++round) {
      between = cells_between();
      if (between.empty() || between.size() > most_halved) break;
      // Half the diagonal of the largest decides how far this round goes.
      double largest = 0;
      for (const std::uint32_t i : between) largest = std::max(largest, half_of(cell(i)));
      finer_.error = std::sqrt(3.0) * largest * field_.tree.lattice.edge / 2 * (1 + 0x1p-40);
      finer_.flat = finer_.error / 4;
      if (!halve_all(between)) break;
    }
    report();
    return findings_;
  }

 private:
  const HeavyCell& cell(std::uint32_t i) const noexcept {
    return i < cells_.size() ? cells_[i] : halved_[i - cells_.size()];
  }

  /// Only those in question: that link two cores, or are in a cluster that touches more than one.
  void drop_idle_doubts() {
    std::vector<bool> asked(cells_.size());
    for (const DoubtCluster& cluster : doubt_clusters(doubts_, joins_)) {
      for (const std::uint32_t i : cluster.cells) asked[i] = cluster.cores.size() > 1;
    }
    std::erase_if(doubts_, [&](const Doubt& d) {
      return !asked[d.a] && !asked[d.b] &&
             (joins_.core_of(d.a) == no_index || joins_.core_of(d.b) == no_index);
    });
  }

  std::vector<Seam> seams() {
    std::erase_if(doubts_, [&](const Doubt& d) { return joins_.root(d.a) == joins_.root(d.b); });
    return seams_between(doubts_, joins_);
  }

  /// All that lie where different cores meet.
  std::vector<std::uint32_t> cells_between() {
    std::vector<std::uint32_t> between;
    for (const Seam& seam : seams()) {
      for (const std::uint32_t i : {seam.doubt.a, seam.doubt.b}) {
        if (!gone_.contains(i) && half_of(cell(i)) > least_half_) between.push_back(i);
      }
    }
    std::sort(between.begin(), between.end());
    between.erase(std::unique(between.begin(), between.end()), between.end());
    return between;
  }

  /// What is left of a cell that is gone is its core point, which lies in one of the cells that took its
  /// place: it stays in doubt with that one until they are joined. False if the lattice ends here.
  bool halve_all(const std::vector<std::uint32_t>& between) {
    gone_.insert(between.begin(), between.end());
    const auto is_now = [&](std::uint32_t i) {
      return std::binary_search(between.begin(), between.end(), i);
    };
    std::multimap<std::uint32_t, std::uint32_t> points;  // by the cell that held them
    for (const std::uint32_t i : between) points.emplace(i, i);
    for (const Doubt& d : doubts_) {
      if (is_now(d.a) && gone_.contains(d.b) && !is_now(d.b)) points.emplace(d.a, d.b);
      if (is_now(d.b) && gone_.contains(d.a) && !is_now(d.a)) points.emplace(d.b, d.a);
    }
    std::erase_if(doubts_, [&](const Doubt& d) { return is_now(d.a) || is_now(d.b); });
    std::vector<std::uint32_t> made;
    for (const std::uint32_t i : between) {
      const std::size_t before = made.size();
      if (!halve(i, made)) return false;
      const auto [first, last] = points.equal_range(i);
      for (auto point = first; point != last; ++point) {
        for (std::size_t k = before; k < made.size(); ++k) tie(point->second, made[k]);
      }
    }
    for (const std::uint32_t i : made) link(i);
    return true;
  }

  void tie(std::uint32_t point, std::uint32_t i) {
    const HeavyCell& from = cell(point);
    const CorePoint core = rule_.core_point(from, half_of(from));
    if (!(core.over > 0)) return;
    if (cores_join(rule_, from, cell(i))) return joins_.cores.join(point, i);
    const Vec3 c = centre_of(from), m = centre_of(cell(i));
    const double reach = std::max(
        {std::fabs(c.x + core.y.x - m.x), std::fabs(c.y + core.y.y - m.y), std::fabs(c.z + core.y.z - m.z)});
    if (reach <= half_of(cell(i))) doubts_.push_back({point, i});
  }

  bool halve(std::uint32_t i, std::vector<std::uint32_t>& made) {
    const Cell at = cell_of(cell(i).key);
    if (at.level >= deepest_level) return false;
    HeavyCells octants;
    HeavyDescent(field_, finer_, octants, progress_).refine(at);
    findings_.looks += octants.looks;
    by_place_.erase(Span::of(cell(i).key).first);
    for (const HeavyCell& octant : octants.cells) {
      made.push_back(static_cast<std::uint32_t>(joins_.cores.add()));
      halved_.push_back(octant);
      by_place_[Span::of(octant.key).first] = made.back();
    }
    return true;
  }

  /// The joins of a halved cell with all that it touches.
  void link(std::uint32_t i) {
    for (const std::uint32_t j : neighbours(i)) {
      const bool is_smaller = half_of(cell(i)) <= half_of(cell(j));
      const Touch touch = is_smaller ? touch_of(rule_, cell(i), cell(j)) : touch_of(rule_, cell(j), cell(i));
      if (touch == Touch::certain) joins_.cores.join(i, j);
      if (touch == Touch::possible) doubts_.push_back({i, j});
    }
  }

  std::vector<std::uint32_t> neighbours(std::uint32_t i) const {
    std::vector<std::uint32_t> found;
    const Span own = Span::of(cell(i).key);
    for (int axis = 0; axis < 3; ++axis) {
      for (const bool up : {false, true}) {
        std::uint64_t place = 0;
        if (CellIndex::beside(own, axis, up, place)) collect({place, own.level}, axis, up, found);
      }
    }
    return found;
  }

  /// The cells that touch the face of a cube of space: one that holds it, or those in it on that face.
  void collect(const Span& cube, int axis, bool up, std::vector<std::uint32_t>& found) const {
    const std::uint32_t holder = at(cube.first);
    if (holder != no_index && Span::of(cell(holder).key).level <= cube.level) return found.push_back(holder);
    if (!is_any_in(cube)) return;
    for (std::uint64_t child = 0; child < 8; ++child) {
      if (((child >> axis & 1U) != 0) == up) continue;
      const Span part{cube.first + child * (cube.size() / 8), cube.level + 1};
      collect(part, axis, up, found);
    }
  }

  std::uint32_t at(std::uint64_t place) const {
    const auto after = by_place_.upper_bound(place);
    if (after != by_place_.begin()) {
      const std::uint32_t i = std::prev(after)->second;
      const Span span = Span::of(cell(i).key);
      if (place - span.first < span.size()) return i;
    }
    const std::size_t i = index_.at(place);
    if (i == CellIndex::none || gone_.contains(static_cast<std::uint32_t>(i))) return no_index;
    return static_cast<std::uint32_t>(i);
  }

  bool is_any_in(const Span& cube) const {
    if (cube.level >= deepest_level) return false;
    const auto halved = by_place_.lower_bound(cube.first);
    if (halved != by_place_.end() && halved->first - cube.first < cube.size()) return true;
    return index_.is_any_in(cube);
  }

  /// Of each pair the place that lies deepest.
  void report() {
    std::vector<Seam> open = seams();
    const auto over = [&](const Seam& seam) {
      return std::max(cell(seam.doubt.a).over, cell(seam.doubt.b).over);
    };
    std::stable_sort(open.begin(), open.end(), [&](const Seam& x, const Seam& y) {
      return std::tuple(x.first, x.second, -over(x)) < std::tuple(y.first, y.second, -over(y));
    });
    for (const Seam& seam : open) {
      if (!findings_.open.empty() && findings_.open.back().first == seam.first &&
          findings_.open.back().second == seam.second)
        continue;
      const HeavyCell &a = cell(seam.doubt.a), &b = cell(seam.doubt.b);
      const Cell at = cell_of(a.over >= b.over ? a.key : b.key);
      findings_.open.push_back({seam.first, seam.second, field_.tree.lattice.centre(at)});
    }
  }

  const FieldData& field_;
  Progress& progress_;
  const Threshold& threshold_;
  CoreRule rule_;
  std::span<const HeavyCell> cells_;
  const CellIndex& index_;
  CellJoins& joins_;
  std::vector<Doubt> doubts_;
  double least_half_;
  Threshold finer_ = threshold_;
  std::vector<HeavyCell> halved_;
  std::map<std::uint64_t, std::uint32_t> by_place_;  ///< of halved cells that are not gone
  std::unordered_set<std::uint32_t> gone_;           ///< halved themselves
  NeckFindings findings_;
};

}  // namespace

NeckFindings look_at_necks(const FieldData& field, const Threshold& threshold,
                           std::span<const HeavyCell> cells, const CellIndex& index, CellJoins& joins,
                           Progress& progress) {
  return Overlay(field, threshold, cells, index, joins, progress).run();
}

}  // namespace cdfr
