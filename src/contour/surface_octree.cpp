#include "contour/surface_octree.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "core/vector.h"
#include "field/batch.h"
#include "field/query.h"

namespace cdfr {
namespace {

/// Cells that a task judges: fixed, so that nothing depends on threads.
constexpr std::size_t cells_a_task = 64;
/// Of cells and list entries, whose numbers are 32 bits; a task more adds at most 2^19 of either.
constexpr std::size_t most_numbers = 0xfff00000U;
/// Of the tolerance: a wedge that corners do not show may reach so far before the cell is split for it.
constexpr double hidden_share = 1.0 / 8;

}  // namespace

/// What was found of a cell.
struct SurfaceOctree::Outcome {
  CellState state = CellState::active;
  bool split = false;
  bool surface_enters = false;
  std::uint8_t planes = 0;
  bool has_list = false;
  std::uint32_t list_size = 0;
};

/// Of some cells one after another, with their lists joined.
struct SurfaceOctree::Task {
  std::vector<Outcome> outcomes;
  std::vector<std::uint32_t> slots;
};

SurfaceOctree::SurfaceOctree(const Sought& sought, const SurfaceLattice& lattice)
    : sought_(sought), lattice_(lattice) {
  cells_.emplace_back();
}

std::vector<std::uint32_t> SurfaceOctree::descend(Progress& progress) {
  std::vector<std::uint32_t> frontier{0}, active;
  while (!frontier.empty()) {
    frontier = judge_all(frontier, active, progress);
    progress.step();
  }
  return active;
}

std::vector<std::uint32_t> SurfaceOctree::split(std::span<const std::uint32_t> leaves, Progress& progress) {
  std::vector<std::uint32_t> frontier, active;
  for (const std::uint32_t leaf : leaves) add_children(leaf, frontier);
  while (!frontier.empty()) frontier = judge_all(frontier, active, progress);
  return active;
}

void SurfaceOctree::add_children(std::uint32_t parent, std::vector<std::uint32_t>& frontier) {
  const auto first = static_cast<std::uint32_t>(cells_.size());
  cells_[parent].state = CellState::inner;
  cells_[parent].first_child = first;
  const SurfaceCell above = cells_[parent];
  const std::uint32_t width = lattice_.width(above.level + 1);
  for (std::uint32_t child = 0; child < 8; ++child) {
    SurfaceCell cell;
    for (std::size_t axis = 0; axis < 3; ++axis)
      cell.lo[axis] = above.lo[axis] + (child >> axis & 1U) * width;
    cell.level = static_cast<std::uint8_t>(above.level + 1);
    cell.parent = parent;
    cell.list = above.list;
    cell.list_size = above.list_size;
    cells_.push_back(cell);
    frontier.push_back(first + child);
  }
}

bool SurfaceOctree::find_near(const SurfaceCell& cell, const Eigen::Vector3d& centre, double distance,
                              std::vector<NearTriangle>& near) const {
  const double size = lattice_.size(cell.level);
  const bool found =
      cell.list != SurfaceCell::no_list
          ? near_triangles(sought_.field, centre, size,
                           std::span<const std::uint32_t>(lists_).subspan(cell.list, cell.list_size), near)
          : near_triangles(sought_.field, centre, size, distance, near);
  return found && !near.empty();
}

bool SurfaceOctree::near(const SurfaceCell& cell, std::vector<NearTriangle>& near) const {
  const Vec3 centre = lattice_.centre(cell.lo, cell.level);
  const double distance = cell.list == SurfaceCell::no_list ? unsigned_distance(sought_.field, centre) : 0;
  return find_near(cell, to_eigen(centre), distance, near);
}

/// A cell that the surface enters: coarse if it is one flat sheet there.
void SurfaceOctree::judge_sheet(const Vec3& centre, double size, const std::vector<NearTriangle>& near,
                                Outcome& outcome) const {
  if (sought_.field.sign == Sign::none) return;
  const Closest closest = closest_point(sought_.field, centre, Finder::tree);
  const TangentPlane plane{closest.distance, to_eigen(closest.gradient)};
  if (!is_sheet(sought_.field, to_eigen(centre), size, sought_.slack, plane, near)) return;
  outcome.split = false;
  const double reach = plane.gradient.lpNorm<1>() * (size / 2) + sought_.slack.above + sought_.rounding;
  if (std::fabs(closest.distance - sought_.distance) > reach) {
    outcome.state = CellState::empty;
  } else {
    outcome.planes = 1;
  }
}

/// `value` is the signed distance at the cell's centre.
void SurfaceOctree::judge(const SurfaceCell& cell, double value, std::vector<NearTriangle>& near,
                          Outcome& outcome) const {
  const double size = lattice_.size(cell.level);
  const Vec3 c = lattice_.centre(cell.lo, cell.level);
  const double radius = half_diagonal(size) * (1 + 0x1p-40) + sought_.rounding;
  near.clear();
  if (std::fabs(value - sought_.distance) > radius) {
    outcome.state = CellState::empty;
    return;
  }
  const double distance = std::fabs(value);
  outcome.surface_enters = distance <= radius;
  if (cell.level >= lattice_.finest()) return;
  outcome.split = true;
  const Eigen::Vector3d centre = to_eigen(c);
  if (!find_near(cell, centre, distance, near)) {
    near.clear();
    return;
  }
  outcome.has_list = true;
  if (outcome.surface_enters) {
    judge_sheet(c, size, near, outcome);
    return;
  }
  const Flatness flat = flatness(sought_.field, centre, size, sought_.slack, near);
  if (flat.planes == 0) return;
  const double height = sought_.height();
  if (flat.least > height + sought_.rounding || flat.most < height - sought_.rounding) {
    outcome.state = CellState::empty;
    outcome.split = false;
    return;
  }
  if (hidden_above(flat, size, height) > hidden_share * sought_.tolerance) return;
  outcome.planes = static_cast<std::uint8_t>(flat.planes);
  outcome.split = false;
}

void SurfaceOctree::judge_some(std::span<const std::uint32_t> some, Task& task, Progress& progress) const {
  std::vector<NearTriangle> near;
  std::vector<Vec3> centres;
  for (const std::uint32_t number : some)
    centres.push_back(lattice_.centre(cells_[number].lo, cells_[number].level));
  std::vector<double> values(centres.size());
  if (!answer(sought_.field, std::span<const Vec3>(centres), 0, std::span(values), progress)) return;
  for (std::size_t i = 0; i < some.size(); ++i) {
    Outcome& outcome = task.outcomes.emplace_back();
    judge(cells_[some[i]], values[i], near, outcome);
    if (!outcome.has_list || outcome.state == CellState::empty) continue;
    outcome.list_size = static_cast<std::uint32_t>(near.size());
    for (const NearTriangle& t : near) task.slots.push_back(t.slot);
  }
}

/// Adds what became an active leaf to `active`, and returns the children of what was split. Empty if
/// cancelled.
std::vector<std::uint32_t> SurfaceOctree::judge_all(std::span<const std::uint32_t> frontier,
                                                    std::vector<std::uint32_t>& active, Progress& progress) {
  std::vector<Task> tasks((frontier.size() + cells_a_task - 1) / cells_a_task);
  for_chunks(frontier.size(), cells_a_task, [&](std::size_t first, std::size_t end) {
    if (progress.poll())
      judge_some(frontier.subspan(first, end - first), tasks[first / cells_a_task], progress);
  });
  if (progress.cancelled()) return {};
  evaluations_ += frontier.size();
  std::vector<std::uint32_t> next;
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    std::size_t list = lists_.size();
    lists_.insert(lists_.end(), tasks[i].slots.begin(), tasks[i].slots.end());
    for (std::size_t k = 0; k < tasks[i].outcomes.size(); ++k) {
      apply(frontier[i * cells_a_task + k], tasks[i].outcomes[k], list, active, next);
      list += tasks[i].outcomes[k].list_size;
    }
    if (cells_.size() > most_numbers || lists_.size() > most_numbers) {
      overflowed_ = true;
      return {};
    }
  }
  return next;
}

/// `list` is where its slots begin.
void SurfaceOctree::apply(std::uint32_t number, const Outcome& outcome, std::size_t list,
                          std::vector<std::uint32_t>& active, std::vector<std::uint32_t>& next) {
  SurfaceCell& cell = cells_[number];
  cell.state = outcome.state;
  cell.planes = outcome.planes;
  cell.surface_enters = outcome.surface_enters;
  if (outcome.list_size > 0) {
    cell.list = static_cast<std::uint32_t>(list);
    cell.list_size = outcome.list_size;
  }
  if (outcome.split) {
    add_children(number, next);
  } else if (outcome.state == CellState::active) {
    active.push_back(number);
    for (std::uint32_t up = number; up != no_index && !cells_[up].busy; up = cells_[up].parent)
      cells_[up].busy = true;
  }
}

}  // namespace cdfr
