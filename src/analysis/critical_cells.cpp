#include "analysis/critical_cells.h"

#include <algorithm>
#include <cmath>

#include "analysis/ascent.h"
#include "analysis/cell_index.h"
#include "analysis/common_direction.h"
#include "analysis/task_cells.h"
#include "core/parallel.h"
#include "core/vector.h"
#include "field/distance_above.h"
#include "field/near_triangles.h"
#include "field/query.h"
#include "geometry/box_distance.h"
#include "geometry/cube.h"
#include "geometry/plain_foot.h"
#include "geometry/query_range.h"

namespace cdfr {
namespace {

/// Cells that one task after another takes.
constexpr int task_level = 1;
/// Far above what unit normals are rounded by.
constexpr double graph_slope = 0x1p-20;

class CriticalDescent {
 public:
  CriticalDescent(const FieldData& field, const CriticalSearch& search, int level, Progress& progress)
      : field_(field),
        search_(search),
        level_(level),
        progress_(progress),
        rounding_(point_rounding(
            std::max(largest_magnitude(field.bounds().lo), largest_magnitude(field.bounds().hi)))),
        ascent_(field) {}

  void run(const Cell& cell) { run(cell, nullptr, false); }
  std::vector<CriticalCell>& found() noexcept { return found_; }

 private:
  /// `among`: slots of the triangles that can be closest in the cell, or null if nothing is known. `inside`:
  /// all of the cell is.
  void run(const Cell& cell, const std::vector<std::uint32_t>* among, bool inside) {
    const Cube cube{field_.tree.lattice.box(cell).lo, field_.tree.lattice.size(cell.level)};
    const double radius = cube.half_diagonal() + rounding_;
    double depth = inside ? 0 : -signed_distance(field_, cube.centre());
    if (!inside && depth + radius <= search_.floor) return;
    std::vector<std::uint32_t> slots;
    const bool known = look(cube, std::fabs(depth), among, slots);
    if (inside) depth = known ? distance_ : -signed_distance(field_, cube.centre());
    if (depth + radius <= search_.floor) return;
    if (known && common_direction(away_, radius).least > radius) return;
    const bool touched = !search_.marked.empty() && (!known || touches(slots));
    if (cell.level == level_) {
      const Vec3 centre = cube.centre();
      found_.push_back({key_of(cell), centre, -signed_distance(field_, centre), touched});
      return;
    }
    inside = depth > radius;
    if (known && !inside && is_graph(slots)) return;
    if (inside && known && settle(cell, cube, depth, slots, touched)) return;
    if (!progress_.poll()) return;
    for (int child = 0; child < 8; ++child) run(child_of(cell, child), known ? &slots : nullptr, inside);
  }

  /// Are these triangles graphs over one plane, inside above, outside below? Then the depth has no critical
  /// point in the cell. Let x be inside, p a closest point, v the way up. The ball about x that touches p holds no
  /// point of the surface, so all of it is inside. Were x - p not going up, the ball would hold points straight
  /// below p, which are outside. So x - p goes along v for every closest p.
  bool is_graph(const std::vector<std::uint32_t>& slots) {
    const bool embedded = field_.report.embedded();
    away_.clear();
    for (const std::uint32_t slot : slots) {
      if (!embedded && field_.triangles.records[slot].sides != Sides::outward) return false;
      const auto& normal = field_.triangles.shape(slot).normal;
      away_.emplace_back(-normal[0].hi, -normal[1].hi, -normal[2].hi);
    }
    return common_direction(away_, graph_slope).least > graph_slope;
  }

  /// The triangles that can be closest in the cube, the vectors from their feet to its centre, and the least
  /// of their lengths. False if they are too many.
  bool look(const Cube& cube, double distance, const std::vector<std::uint32_t>* among,
            std::vector<std::uint32_t>& slots) {
    const Eigen::Vector3d centre = to_eigen(cube.centre());
    const bool known = among != nullptr ? near_triangles(field_, centre, cube.size, *among, near_)
                                        : near_triangles(field_, centre, cube.size, distance, near_);
    if (!known) return false;
    away_.clear();
    distance_ = HUGE_VAL;
    for (const NearTriangle& near : near_) {
      slots.push_back(near.slot);
      away_.emplace_back(near.foot.gradient * near.foot.distance);
      distance_ = std::min(distance_, near.foot.distance);
    }
    return true;
  }

  bool touches(const std::vector<std::uint32_t>& slots) const noexcept {
    return std::any_of(slots.begin(), slots.end(),
                       [&](std::uint32_t slot) { return search_.marked[slot] != 0; });
  }

  /// Takes the cell as it is if its core tells enough: of a marked triangle too, if one is near.
  /// Precondition: all of the cell is inside.
  bool settle(const Cell& cell, const Cube& cube, double depth, std::span<const std::uint32_t> among,
              bool touched) {
    if (cube.size * cube.size > search_.error * depth) return false;
    const double most = distance_above(field_, cube.lo, cube.size) + rounding_;
    const Vec3 core = ascent_.top_in(cube, depth, search_.error / 8, among);
    const double reached = -signed_distance(field_, core);
    if (most > reached + search_.error / 2) return false;
    if (touched && !is_touched(core, reached, among)) return false;
    if (reached > search_.floor) found_.push_back({key_of(cell), core, reached, touched});
    return true;
  }

  /// Does the ball about the core, larger by half the error, meet a marked triangle?
  bool is_touched(const Vec3& core, double depth, std::span<const std::uint32_t> among) const {
    return std::any_of(among.begin(), among.end(), [&](std::uint32_t slot) {
      return search_.marked[slot] != 0 &&
             plain_foot(to_eigen(core), field_.triangles.shape(slot)).distance <= depth + search_.error / 2;
    });
  }

  const FieldData& field_;
  const CriticalSearch& search_;
  int level_;
  Progress& progress_;
  double rounding_;
  double distance_ = 0;
  Ascent ascent_;
  std::vector<NearTriangle> near_;
  std::vector<Eigen::Vector3d> away_;
  std::vector<CriticalCell> found_;
};

}  // namespace

std::size_t CriticalCells::find(const Cell& cell) const noexcept {
  const std::uint64_t first = Span::of(key_of(cell)).first;
  const auto after = std::upper_bound(
      cells.begin(), cells.end(), first,
      [](std::uint64_t place, const CriticalCell& other) { return place < Span::of(other.key).first; });
  if (after == cells.begin()) return none;
  const Span span = Span::of((after - 1)->key);
  return first - span.first < span.size() ? static_cast<std::size_t>(after - 1 - cells.begin()) : none;
}

int level_of_error(const Lattice& lattice, double error) noexcept {
  int level = 0;
  while (level <= deepest_level && Cube{{}, lattice.size(level)}.half_diagonal() > error / 2) ++level;
  return level;
}

CriticalCells critical_cells(const FieldData& field, const CriticalSearch& search, Progress& progress) {
  const Lattice& lattice = field.tree.lattice;
  const int level = level_of_error(lattice, search.error);
  CriticalCells critical{level, lattice.size(level), {}};
  const std::vector<Cell> tasks = task_cells(lattice, std::min(level, task_level));
  std::vector<std::vector<CriticalCell>> found(tasks.size());
  progress.phase(0.1, 0.5, static_cast<double>(tasks.size()));
  for_chunks(tasks.size(), 1, [&](std::size_t i, std::size_t) {
    CriticalDescent descent(field, search, level, progress);
    descent.run(tasks[i]);
    found[i] = std::move(descent.found());
    progress.step();
  });
  if (progress.cancelled()) return critical;
  for (const std::vector<CriticalCell>& part : found)
    critical.cells.insert(critical.cells.end(), part.begin(), part.end());
  std::sort(critical.cells.begin(), critical.cells.end(), [](const CriticalCell& a, const CriticalCell& b) {
    return Span::of(a.key).first < Span::of(b.key).first;
  });
  return critical;
}

double way_depth(const Vec3& a, double depth_a, const Vec3& b, double depth_b) noexcept {
  const double apart = distance_between(a, b), square = apart * apart;
  const double from = depth_a * depth_a, to = depth_b * depth_b;
  const double least = std::min(depth_a, depth_b);
  if (!(square > 0)) return least;
  const double t = (square + from - to) / (2 * square);
  if (t <= 0 || t >= 1) return least;
  // Rounds by a few u of the largest term; what is left over it is far below any error asked for.
  return std::sqrt(std::max(0.0, from - t * t * square));
}

}  // namespace cdfr
