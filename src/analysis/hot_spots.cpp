#include "cdfr/analysis/hot_spots.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "analysis/critical_cells.h"
#include "analysis/depth_tree.h"
#include "analysis/near_ball.h"
#include "analysis/sphere_depth.h"
#include "core/floating_environment.h"
#include "core/parallel.h"
#include "core/progress.h"
#include "field/deepest.h"
#include "field/deepest_search.h"
#include "geometry/box_distance.h"
#include "geometry/query_range.h"

namespace cdfr {
namespace {

constexpr double default_share = 1.0 / 20;  ///< of the greatest depth
/// A ball is known so much better than necks are.
constexpr double ball_share = 1.0 / 64;
/// Peaks of more cells that are about as deep, such as the middle of a plate, keep the error of their cells.
constexpr std::size_t most_top_cells = 4096;

class HotSpotSearch {
 public:
  HotSpotSearch(const FieldData& field, const HotSpotOptions& options, Progress& progress)
      : field_(field), options_(options), progress_(progress) {}

  Result<HotSpots> run() {
    if (Result<void> there = check_feeders(); !there) return there.error();
    if (Result<void> taken = take_options(); !taken) return taken.error();
    // Nothing is deep enough for a hot spot of that prominence.
    if (!(deepest_.depth > 0)) return found_;
    // Walls thinner than the error do not lead anywhere.
    const double floor = found_.error;
    const std::vector<std::uint8_t> marks = marked();
    critical_ = critical_cells(field_, {found_.error, floor, marks}, progress_);
    found_.critical_cells = critical_.cells.size();
    std::vector<DepthLink> links = depth_links(field_, critical_, floor, progress_);
    if (!progress_.poll()) return ended();
    peaks_ = depth_tree(critical_, std::move(links), found_.prominence);
    describe();
    if (!progress_.poll()) return ended();
    return found_;
  }

 private:
  Error ended() const { return field_.failed() ? field_.status().error() : Progress::error(); }

  Result<void> take_options() {
    const double longest = longest_side(field_.bounds());
    Result<Deepest> deepest = deepest_point(field_, longest / 1000, progress_);
    if (!deepest) return deepest.error();
    deepest_ = *deepest;
    const double share = deepest_.depth * default_share;
    found_.error = options_.error > 0 ? options_.error : std::max(longest / 1000, share);
    found_.prominence = options_.prominence > 0 ? options_.prominence : std::max(2 * found_.error, share);
    const double rounding = point_rounding(
        std::max(largest_magnitude(field_.bounds().lo), largest_magnitude(field_.bounds().hi)));
    if (level_of_error(field_.tree.lattice, found_.error) > deepest_level || found_.error < 64 * rounding)
      return Error{Code::bad_option, 0, "error is too small for this part's size"};
    if (found_.prominence < 2 * found_.error)
      return Error{Code::bad_option, 0, "prominence must be at least twice the error"};
    return {};
  }

  Result<void> check_feeders() const {
    for (const std::uint32_t patch : options_.feeders) {
      const auto& triangles = field_.triangles.exact;
      if (std::none_of(triangles.begin(), triangles.end(),
                       [&](const ExactTriangle& t) { return t.patch == patch; }))
        return Error{Code::bad_option, patch, "no triangle is of patch " + std::to_string(patch)};
    }
    return {};
  }

  /// By slot; empty if there is no feeder.
  std::vector<std::uint8_t> marked() const {
    if (options_.feeders.empty()) return {};
    std::vector<std::uint8_t> marks(field_.triangles.size());
    for (std::uint32_t slot = 0; slot < marks.size(); ++slot) {
      const std::uint32_t patch = field_.triangles.exact[slot].patch;
      marks[slot] =
          std::find(options_.feeders.begin(), options_.feeders.end(), patch) != options_.feeders.end();
    }
    return marks;
  }

  Cube cube_of(const CriticalCell& critical) const noexcept {
    const Cell cell = cell_of(critical.key);
    return {field_.tree.lattice.box(cell).lo, field_.tree.lattice.size(cell.level)};
  }

  void describe() {
    found_.spots.resize(peaks_.size());
    progress_.phase(0.8, 1, static_cast<double>(peaks_.size()));
    for_chunks(peaks_.size(), 1, [&](std::size_t i, std::size_t) {
      if (!progress_.poll()) return;
      found_.spots[i] = spot(peaks_[i]);
      progress_.step();
    });
    order();
  }

  HotSpot spot(const DepthPeak& peak) {
    HotSpot spot;
    spot.ball = ball_of(critical_.cells[peak.cell]);
    spot.prominence = spot.ball.radius - peak.neck_depth;
    if (peak.elder != DepthPeak::none) {
      spot.neck = {peak.neck, peak.neck_depth, found_.error};
      const auto elder = std::find_if(peaks_.begin(), peaks_.end(),
                                      [&](const DepthPeak& other) { return other.cell == peak.elder; });
      spot.towards = static_cast<std::size_t>(elder - peaks_.begin());
    }
    spot.wall = depth_on_sphere(field_, spot.ball.centre, 2 * spot.ball.radius, found_.error, progress_);
    spot.isolation = spot.wall > 0 ? spot.ball.radius / spot.wall : std::numeric_limits<double>::infinity();
    spot.fed = peak.fed;
    if (peak.fed) spot.feed = {peak.feed, peak.feed_depth, found_.error};
    return spot;
  }

  /// Critical cells about the peak that may hold a deeper point than its core.
  std::vector<Cube> top_of(const CriticalCell& peak) const {
    std::vector<Cube> cubes;
    for (const CriticalCell& cell : critical_.cells) {
      const Cube cube = cube_of(cell);
      if (cell.depth + found_.error < peak.depth || distance_between(cell.core, peak.core) > peak.depth / 2)
        continue;
      cubes.push_back(cube);
      if (cubes.size() > most_top_cells) return {};
    }
    return cubes;
  }

  InscribedBall ball_of(const CriticalCell& peak) {
    InscribedBall ball{peak.core, peak.depth, found_.error / 2, {}};
    if (const std::vector<Cube> top = top_of(peak); !top.empty()) {
      DeepestSearch search(field_, {.error = found_.error * ball_share}, progress_);
      std::vector<DeepestSearch::Looked> looked;
      for (const Cube& cube : top) looked.push_back(search.look(cube));
      const Deepest deepest = search.run(looked);
      ball = {deepest.point, deepest.depth, deepest.error, {}};
    }
    ball.touches = triangles_within(field_, ball.centre, ball.radius + 2 * ball.error);
    return ball;
  }

  /// By the balls, which are better known than the cells that the peaks were ordered by.
  void order() {
    std::vector<std::size_t> by_radius(found_.spots.size()), place(found_.spots.size());
    for (std::size_t i = 0; i < by_radius.size(); ++i) by_radius[i] = i;
    std::stable_sort(by_radius.begin(), by_radius.end(), [&](std::size_t a, std::size_t b) {
      return found_.spots[a].ball.radius > found_.spots[b].ball.radius;
    });
    std::vector<HotSpot> sorted;
    for (std::size_t i = 0; i < by_radius.size(); ++i) {
      place[by_radius[i]] = i;
      sorted.push_back(std::move(found_.spots[by_radius[i]]));
    }
    for (HotSpot& spot : sorted) {
      if (spot.towards != HotSpot::none) spot.towards = place[spot.towards];
    }
    found_.spots = std::move(sorted);
  }

  const FieldData& field_;
  const HotSpotOptions& options_;
  Progress& progress_;
  Deepest deepest_;
  CriticalCells critical_;
  std::vector<DepthPeak> peaks_;
  HotSpots found_;
};

Result<void> check(const FieldData& field, const HotSpotOptions& options) {
  const auto is_size = [](double v) { return v >= 0 && std::isfinite(v); };
  if (!is_size(options.error)) return Error{Code::bad_option, 0, "error must be 0 or more and finite"};
  if (!is_size(options.prominence))
    return Error{Code::bad_option, 0, "prominence must be 0 or more and finite"};
  if (field.sign == Sign::none)
    return Error{Code::not_closed, 0, "an unsigned field has no inside: no hot spots"};
  if (!field.winding.empty())
    return Error{Code::not_closed, 0, "the mesh is open, so depth jumps off its surface: no hot spots"};
  return {};
}

}  // namespace

Result<HotSpots> hot_spots(const Field& field, const HotSpotOptions& options, const Run& run) {
  const FieldData& data = field.data();
  if (Result<void> good = check(data, options); !good) return good.error();
  const FloatingEnvironment environment;
  Progress progress(run);
  progress.watch(data.map.get());
  Result<HotSpots> spots = Progress::error();
  with_threads(run, [&] { spots = HotSpotSearch(data, options, progress).run(); });
  return spots;
}

}  // namespace cdfr
