#include "cdfr/analysis/sections.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "analysis/cell_index.h"
#include "analysis/cell_joins.h"
#include "analysis/heavy_descent.h"
#include "analysis/near_ball.h"
#include "analysis/necks.h"
#include "analysis/section_measure.h"
#include "core/floating_environment.h"
#include "core/parallel.h"
#include "core/progress.h"
#include "field/deepest_search.h"
#include "field/leaves.h"
#include "field/query.h"
#include "geometry/box_distance.h"
#include "geometry/query_range.h"

namespace cdfr {
namespace {

/// Shares of e: to which a cube may count as flat, and the ball's.
constexpr double flat_share = 0.5, ball_share = 1.0 / 32;
/// Of the last steps of a ball's centre, in e.
constexpr double least_step = 0x1p-10;
/// Least e, as a share of the longest side: cells then leave some levels of the lattice to necks.
constexpr double least_error = 0x1p-14;
/// Cubes that may be halved to prove that a cluster of cells holds nothing deeper than T, and places listed
/// where that did not do.
constexpr std::uint64_t most_halved = 4096;
constexpr std::size_t most_places = 1000;

/// Blocks that are descended into at once: what they find lies ready twice for a while.
constexpr std::size_t blocks_a_wave = 16;

void append(HeavyCells& all, const HeavyCells& own) {
  const auto before = static_cast<std::uint32_t>(all.cells.size());
  all.cells.insert(all.cells.end(), own.cells.begin(), own.cells.end());
  for (const CellTriangle& pair : own.triangles) all.triangles.push_back({pair.cell + before, pair.slot});
  all.looks += own.looks;
}

HeavyCells cells_in_block(const FieldData& field, const Threshold& threshold, std::size_t number,
                          Progress& progress) {
  HeavyCells found;
  const Block block = field.tree.block(number);
  HeavyDescent descent(field, threshold, found, progress);
  for_each_leaf(block, [&](const Cell& cell, std::uint32_t leaf_number) {
    if (!progress.poll()) return;
    const LeafRecord& leaf = block.leaves[leaf_number];
    descent.run(cell, {block.entries.data() + leaf.first, leaf.count()}, leaf.side());
  });
  progress.step();
  return found;
}

HeavyCells all_cells(const FieldData& field, const Threshold& threshold, Progress& progress) {
  const std::size_t blocks = field.tree.block_count();
  progress.phase(0, 0.7, static_cast<double>(blocks));
  HeavyCells all;
  std::vector<HeavyCells> wave(blocks_a_wave);
  for (std::size_t first = 0; first < blocks && !progress.cancelled(); first += blocks_a_wave) {
    const std::size_t count = std::min(blocks_a_wave, blocks - first);
    for_chunks(count, 1, [&](std::size_t i, std::size_t) {
      wave[i] = cells_in_block(field, threshold, first + i, progress);
    });
    for (std::size_t i = 0; i < count; ++i) append(all, std::exchange(wave[i], {}));
  }
  return all;
}

class SectionSearch {
 public:
  SectionSearch(const FieldData& field, const Threshold& threshold, const SectionsOptions& options,
                Progress& progress)
      : field_(field),
        threshold_(threshold),
        rule_(threshold, field.tree.lattice),
        options_(options),
        progress_(progress),
        found_(all_cells(field, threshold, progress)),
        index_(found_.cells),
        joins_(join_cells(rule_, found_.cells, index_, progress)) {}

  Result<Sections> run() {
    const std::vector<Doubt> doubts = joins_.doubts;
    const NeckFindings necks = look_at_necks(field_, threshold_, found_.cells, index_, joins_, progress_);
    if (!progress_.cancelled()) group(doubts);
    if (!progress_.cancelled()) measure(doubts);
    if (!progress_.cancelled()) find_balls();
    if (field_.failed()) return field_.status().error();
    if (progress_.cancelled()) return Progress::error();
    sections_.depth = threshold_.depth;
    sections_.error = threshold_.error;
    sections_.cells = found_.cells.size();
    sections_.evaluations = found_.looks + necks.looks;
    rank(necks);
    return std::move(sections_);
  }

 private:
  static constexpr std::uint32_t none = no_index;

  std::uint32_t core_of(std::uint32_t i) noexcept { return joins_.core_of(i); }
  Cube cube_of(std::uint32_t i) const noexcept {
    const Lattice& lattice = field_.tree.lattice;
    const Cell cell = cell_of(found_.cells[i].key);
    return {lattice.box(cell).lo, lattice.size(cell.level)};
  }

  /// Gives each cell its section: its core's, or the first one that its cluster touches.
  void group(const std::vector<Doubt>& doubts) {
    section_of_.assign(found_.cells.size(), none);
    std::vector<std::uint32_t> lone;
    for (std::uint32_t i = 0; i < section_of_.size(); ++i) {
      const std::uint32_t core = core_of(i);
      if (core == i) section_of_[i] = count_++;
      if (core != none) section_of_[i] = section_of_[core];
    }
    clusters_ = doubt_clusters(doubts, joins_);
    std::vector<bool> clustered(section_of_.size());
    for (const DoubtCluster& cluster : clusters_) {
      for (const std::uint32_t i : cluster.cells) clustered[i] = true;
      if (!cluster.cores.empty()) {
        for (const std::uint32_t i : cluster.cells) section_of_[i] = section_of_[cluster.cores[0]];
      } else {
        prove(cluster.cells);
      }
    }
    for (std::uint32_t i = 0; i < section_of_.size(); ++i) {
      if (section_of_[i] == none && !clustered[i]) prove(std::span(&i, 1));
    }
  }

  /// Cells without a core: a section if a point of them is deeper than T.
  void prove(std::span<const std::uint32_t> cells) {
    if (!progress_.poll()) return;
    DeepestSearch search(
        field_, {threshold_.rounding, threshold_.depth + threshold_.rounding, true, most_halved}, progress_);
    std::vector<DeepestSearch::Looked> looked;
    for (const std::uint32_t i : cells) looked.push_back(search.look(cube_of(i)));
    const Deepest deepest = search.run(looked);
    if (deepest.depth > threshold_.depth + threshold_.rounding) {
      for (const std::uint32_t i : cells) section_of_[i] = count_;
      ++count_;
    } else if (search.is_open()) {
      tell_undecided(cube_of(cells[0]).centre());
    }
  }

  void tell_undecided(const Vec3& place) {
    if (sections_.undecided.size() < most_places) sections_.undecided.push_back(place);
  }

  void measure(const std::vector<Doubt>& doubts) {
    measures_.resize(count_);
    for (std::uint32_t i = 0; i < section_of_.size(); ++i) {
      if (section_of_[i] != none) measures_[section_of_[i]].add(rule_, found_.cells[i]);
    }
    // What lies between different sections may belong to each of them.
    for (const DoubtCluster& cluster : clusters_) {
      for (std::size_t k = 1; k < cluster.cores.size(); ++k) {
        for (const std::uint32_t i : cluster.cells)
          measures_[section_of_[cluster.cores[k]]].add_doubtful(found_.cells[i]);
      }
    }
    for (const Doubt& doubt : doubts) {
      const std::uint32_t a = core_of(doubt.a), b = core_of(doubt.b);
      if (a == none || b == none || a == b) continue;
      measures_[section_of_[a]].add_doubtful(found_.cells[doubt.b]);
      measures_[section_of_[b]].add_doubtful(found_.cells[doubt.a]);
    }
    for (const CellTriangle& pair : found_.triangles) {
      if (section_of_[pair.cell] != none)
        measures_[section_of_[pair.cell]].add_triangle(field_.triangles.records[pair.slot].number);
    }
    found_.triangles = {};
  }

  /// Of each section the cells that may hold its deepest point, then that point.
  void find_balls() {
    std::vector<std::vector<std::uint32_t>> deep(count_);
    for (std::uint32_t i = 0; i < section_of_.size(); ++i) {
      if (section_of_[i] == none) continue;
      const double best = measures_[section_of_[i]].deepest();
      if (found_.cells[i].most(half_of(found_.cells[i])) >= best * (1 - 0x1p-20))
        deep[section_of_[i]].push_back(i);
    }
    progress_.phase(0.8, 1, static_cast<double>(count_));
    sections_.sections.resize(count_);
    for_chunks(count_, 1, [&](std::size_t s, std::size_t) {
      sections_.sections[s] = measures_[s].section(field_.tree.lattice);
      sections_.sections[s].ball = ball_in(deep[s]);
      progress_.step();
    });
  }

  /// Of radius 0 if no point deeper than T was found.
  InscribedBall ball_in(std::span<const std::uint32_t> cells) const {
    Deepest deepest = deepest_of(cells, {threshold_.error * ball_share, threshold_.depth});
    // A section may be less deep than what the search leaves open: then any point of it comes first.
    if (!(deepest.depth > threshold_.depth)) {
      const double bound = deepest.depth + deepest.error;
      deepest = deepest_of(cells, {threshold_.rounding / 4, threshold_.depth, true, most_halved});
      if (!(deepest.depth > threshold_.depth)) return {};
      deepest.error = std::max(bound - deepest.depth, threshold_.rounding);
    }
    InscribedBall ball{deepest.point, deepest.depth, 0, {}};
    climb(ball);
    ball.error = std::max(deepest.depth + deepest.error - ball.radius, threshold_.rounding / 16);
    ball.touches = triangles_within(field_, ball.centre, ball.radius + 2 * ball.error);
    return ball;
  }

  Deepest deepest_of(std::span<const std::uint32_t> cells, const DeepestSearch::Goal& goal) const {
    DeepestSearch search(field_, goal, progress_);
    std::vector<DeepestSearch::Looked> looked;
    for (const std::uint32_t i : cells) looked.push_back(search.look(cube_of(i)));
    return search.run(looked);
  }

  /// Is the way between two points of those depths all deeper than T?
  bool stays_within(double from, double to, double apart) const noexcept {
    const double edge = field_.tree.lattice.edge, own = threshold_.depth;
    return rule_.joins((from - own) / edge, (to - own) / edge, (apart / edge) * (apart / edge));
  }

  /// Moves the centre to where it is deeper, along the axes by ever smaller steps: what is known of the
  /// largest ball stays, so each step takes as much from the error.
  void climb(InscribedBall& ball) const {
    for (double step = threshold_.error / 2; step > threshold_.error * least_step; step /= 2) {
      for (bool moved = true; moved;) {
        moved = false;
        for (int way = 0; way < 6; ++way) {
          const double by = way % 2 == 0 ? step : -step;
          Vec3 x = ball.centre;
          (way < 2 ? x.x : way < 4 ? x.y : x.z) += by;
          const double depth = -signed_distance(field_, x);
          // Of the steps that go on and on those by a hair are left out.
          if (depth <= ball.radius + step * 0x1p-6 || !stays_within(ball.radius, depth, step)) continue;
          ball.centre = x;
          ball.radius = depth;
          moved = true;
        }
      }
    }
  }

  /// Largest first; of equal balls the first in space.
  void rank(const NeckFindings& necks) {
    std::vector<std::size_t> order(count_);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::vector<Section>& all = sections_.sections;
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return all[a].ball.radius > all[b].ball.radius; });
    std::vector<std::optional<std::size_t>> place(count_);
    std::vector<Section> ranked;
    for (const std::size_t s : order) {
      if (all[s].ball.radius == 0) {
        const Box& box = all[s].box;
        tell_undecided({(box.lo.x + box.hi.x) / 2, (box.lo.y + box.hi.y) / 2, (box.lo.z + box.hi.z) / 2});
        continue;
      }
      if (all[s].volume < options_.min_volume || all[s].ball.radius < options_.min_depth) {
        ++sections_.left_out;
        continue;
      }
      place[s] = ranked.size();
      ranked.push_back(std::move(all[s]));
    }
    all = std::move(ranked);
    for (const OpenNeck& neck : necks.open) {
      const auto a = place[section_of_[neck.first]], b = place[section_of_[neck.second]];
      if (!a || !b) continue;
      sections_.may_join.push_back(
          {std::min(*a, *b), std::max(*a, *b), neck.place, -signed_distance(field_, neck.place)});
    }
    std::sort(sections_.may_join.begin(), sections_.may_join.end(), [](const MayJoin& x, const MayJoin& y) {
      return std::pair(x.first, x.second) < std::pair(y.first, y.second);
    });
  }

  const FieldData& field_;
  const Threshold& threshold_;
  CoreRule rule_;
  const SectionsOptions& options_;
  Progress& progress_;
  HeavyCells found_;
  CellIndex index_;
  CellJoins joins_;
  std::vector<DoubtCluster> clusters_;
  std::vector<std::uint32_t> section_of_;  ///< by cell
  std::uint32_t count_ = 0;
  std::vector<SectionMeasure> measures_;
  Sections sections_;
};

bool is_at_least_zero(double v) noexcept { return v >= 0 && std::isfinite(v); }

}  // namespace

Result<Sections> heavy_sections(const Field& field, double depth, const SectionsOptions& options,
                                const Run& run) {
  const FloatingEnvironment environment;
  const FieldData& data = field.data();
  const double longest = longest_side(data.bounds());
  const double error = options.error == 0 ? longest / 1000 : options.error;
  if (!(depth > 0) || !std::isfinite(depth)) return Error{Code::bad_option, 0, "depth must be above 0"};
  if (!is_at_least_zero(options.min_volume) || !is_at_least_zero(options.min_depth))
    return Error{Code::bad_option, 0, "the least volume and depth must be finite and not negative"};
  const double rounding =
      16 * point_rounding(std::max(largest_magnitude(data.bounds().lo), largest_magnitude(data.bounds().hi)));
  if (!(error >= longest * least_error) || !(error >= 64 * rounding) || !std::isfinite(error)) {
    return Error{
        Code::bad_option, 0,
        "the error must be at least 2^-14 of the longest side, and 2^14 ulp of the largest coordinate"};
  }
  if (data.sign == Sign::none) {
    return Error{Code::not_closed, 0, "an unsigned field has no inside: no section of it is heavy"};
  }
  const Threshold threshold{depth, error, error * flat_share, rounding, !data.winding.empty()};
  Progress progress(run);
  progress.watch(data.map.get());
  Result<Sections> sections = Progress::error();
  with_threads(run, [&] { sections = SectionSearch(data, threshold, options, progress).run(); });
  return sections;
}

}  // namespace cdfr
