#include "analysis/critical_cells.h"

#include <algorithm>
#include <cmath>

#include "analysis/common_direction.h"
#include "core/parallel.h"
#include "core/vector.h"
#include "field/near_triangles.h"
#include "field/query.h"
#include "geometry/cube.h"
#include "geometry/query_range.h"

namespace cdfr {
namespace {

/// Cells that one task after another takes.
constexpr int task_level = 1;

class CriticalDescent {
 public:
  CriticalDescent(const FieldData& field, int level, double floor, std::span<const std::uint8_t> marked,
                  Progress& progress)
      : field_(field),
        level_(level),
        floor_(floor),
        marked_(marked),
        progress_(progress),
        rounding_(point_rounding(
            std::max(largest_magnitude(field.bounds().lo), largest_magnitude(field.bounds().hi)))) {}

  void run(const Cell& cell) { run(cell, nullptr, false); }
  std::vector<CriticalCell>& found() noexcept { return found_; }

 private:
  /// `among`: slots of the triangles that can be closest in the cell, or null if nothing is known. `inside`:
  /// all of the cell is.
  void run(const Cell& cell, const std::vector<std::uint32_t>* among, bool inside) {
    const Cube cube{field_.tree.lattice.box(cell).lo, field_.tree.lattice.size(cell.level)};
    const double radius = cube.half_diagonal() + rounding_;
    double depth = inside ? 0 : -signed_distance(field_, cube.centre());
    if (!inside && depth + radius <= floor_) return;
    std::vector<std::uint32_t> slots;
    const bool known = look(cube, std::fabs(depth), among, slots);
    if (inside) depth = known ? distance_ : -signed_distance(field_, cube.centre());
    if (depth + radius <= floor_) return;
    if (known && common_direction(away_, radius).least > radius) return;
    if (cell.level == level_) {
      found_.push_back({key_of(cell), -signed_distance(field_, cube.centre()), !known || touches(slots)});
      return;
    }
    if (!progress_.poll()) return;
    for (int child = 0; child < 8; ++child)
      run(child_of(cell, child), known ? &slots : nullptr, depth > radius);
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
    return !marked_.empty() &&
           std::any_of(slots.begin(), slots.end(), [&](std::uint32_t slot) { return marked_[slot] != 0; });
  }

  const FieldData& field_;
  int level_;
  double floor_;
  std::span<const std::uint8_t> marked_;
  Progress& progress_;
  double rounding_;
  double distance_ = 0;
  std::vector<NearTriangle> near_;
  std::vector<Eigen::Vector3d> away_;
  std::vector<CriticalCell> found_;
};

std::vector<Cell> task_cells(const Lattice& lattice, int level) {
  std::vector<Cell> cells;
  const auto along = [&](int axis) { return lattice.bricks[static_cast<std::size_t>(axis)] << level; };
  for (std::uint32_t z = 0; z < along(2); ++z)
    for (std::uint32_t y = 0; y < along(1); ++y)
      for (std::uint32_t x = 0; x < along(0); ++x) cells.push_back({level, {x, y, z}});
  return cells;
}

}  // namespace

std::size_t CriticalCells::find(std::uint64_t key) const noexcept {
  const auto at = std::lower_bound(cells.begin(), cells.end(), key,
                                   [](const CriticalCell& cell, std::uint64_t k) { return cell.key < k; });
  return at != cells.end() && at->key == key ? static_cast<std::size_t>(at - cells.begin()) : none;
}

int level_of_error(const Lattice& lattice, double error) noexcept {
  int level = 0;
  while (level <= deepest_level && Cube{{}, lattice.size(level)}.half_diagonal() > error / 2) ++level;
  return level;
}

CriticalCells critical_cells(const FieldData& field, int level, double floor,
                             std::span<const std::uint8_t> marked, Progress& progress) {
  CriticalCells critical{level, field.tree.lattice.size(level), {}};
  const std::vector<Cell> tasks = task_cells(field.tree.lattice, std::min(level, task_level));
  std::vector<std::vector<CriticalCell>> found(tasks.size());
  progress.phase(0.1, 0.5, static_cast<double>(tasks.size()));
  for_chunks(tasks.size(), 1, [&](std::size_t i, std::size_t) {
    CriticalDescent descent(field, level, floor, marked, progress);
    descent.run(tasks[i]);
    found[i] = std::move(descent.found());
    progress.step();
  });
  if (progress.cancelled()) return critical;
  for (const std::vector<CriticalCell>& part : found)
    critical.cells.insert(critical.cells.end(), part.begin(), part.end());
  std::sort(critical.cells.begin(), critical.cells.end(),
            [](const CriticalCell& a, const CriticalCell& b) { return a.key < b.key; });
  return critical;
}

}  // namespace cdfr
