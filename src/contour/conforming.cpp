#include "contour/conforming.h"

#include <algorithm>

#include "contour/cell_walk.h"
#include "core/parallel.h"

namespace cdfr {
namespace {

constexpr std::size_t leaves_a_task = 256;

}  // namespace

bool Conforming::run(Progress& progress) {
  walk();
  for (;;) {
    while (!to_split_.empty()) {
      if (!split_marked(progress)) return false;
      walk();
    }
    const std::vector<SurfaceLeaf>& leaves = leaves_.leaves();
    std::erase_if(faces_, [&](const MinimalFace& face) {
      return !leaves[face.below].live || !leaves[face.above].live;
    });
    curves_.collect(faces_);
    if (!close_loops(progress)) return false;
    if (to_split_.empty()) return true;
  }
}

void Conforming::mark(std::uint32_t leaf) {
  if (leaves_.level(leaves_.leaves()[leaf]) == leaves_.octree().lattice().deepest || marked_[leaf]) return;
  marked_[leaf] = 1;
  to_split_.push_back(leaf);
}

bool Conforming::split_marked(Progress& progress) {
  std::vector<std::uint32_t> split;
  split.swap(to_split_);
  std::ranges::sort(split);
  return leaves_.split(split, progress);
}

void Conforming::walk() {
  const std::vector<SurfaceCell>& cells = leaves_.octree().cells();
  const std::vector<SurfaceLeaf>& leaves = leaves_.leaves();
  marked_.resize(leaves.size());
  seen_.resize(cells.size());
  ++walks_;
  for (; walked_ < leaves.size(); ++walked_) {
    for (std::uint32_t up = leaves[walked_].cell; up != no_index && seen_[up] != walks_;
         up = cells[up].parent)
      seen_[up] = walks_;
  }
  const auto sought = [&](std::uint32_t cell) { return seen_[cell] == walks_; };
  const auto on_edge = [this](unsigned axis, const std::array<std::uint32_t, 4>& around) {
    cross(axis, around);
  };
  const std::size_t first_face = faces_.size();
  const auto on_face = [&](unsigned axis, std::uint32_t below, std::uint32_t above) {
    faces_.push_back({cells[below].leaf, cells[above].leaf, static_cast<std::uint8_t>(axis), 0,
                      cells[above].level > cells[below].level});
  };
  CellWalk(cells, sought, on_edge, on_face).run();
  for (std::size_t i = first_face; i < faces_.size(); ++i) check_face(faces_[i]);
}

/// The edge is a side of the smallest leaf; the leaf at u, w has it at its other end of u and w.
void Conforming::cross(unsigned axis, const std::array<std::uint32_t, 4>& around) {
  const std::vector<SurfaceCell>& cells = leaves_.octree().cells();
  std::size_t smallest = 0;
  for (std::size_t i = 1; i < 4; ++i) {
    if (cells[around[i]].level > cells[around[smallest]].level) smallest = i;
  }
  const auto side_at = [&](std::size_t i) {
    return side_number(static_cast<int>(axis), i & 1 ? 0 : 1, i & 2 ? 0 : 1);
  };
  const SurfaceLeaf& leaf = leaves_.leaves()[cells[around[smallest]].leaf];
  const int low = side_corner(side_at(smallest)), high = low | 1 << axis;
  if ((leaf.held >> low & 1) == (leaf.held >> high & 1)) return;
  // Another leaf of that size may have been there before.
  std::uint32_t crossing = no_index;
  for (std::size_t i = 0; i < 4 && crossing == no_index; ++i) {
    if (cells[around[i]].level == cells[around[smallest]].level)
      crossing = leaves_.leaves()[cells[around[i]].leaf].sides[side_at(i)];
  }
  if (crossing == no_index)
    crossing = crossings_.add(static_cast<int>(axis), leaf.corners[low], leaf.corners[high]);
  for (std::size_t i = 0; i < 4; ++i) {
    // A leaf that has the edge in the middle of its face comes twice.
    if (around[i] != around[i ^ 1] && around[i] != around[i ^ 2])
      set_side(cells[around[i]].leaf, side_at(i), crossing);
  }
}

/// A crossing gives way to one on a part of its edge, which has become minimal; any other one is a second
/// crossing.
void Conforming::set_side(std::uint32_t leaf, int side, std::uint32_t crossing) {
  std::uint32_t& there = leaves_.leaves()[leaf].sides[side];
  if (there != no_index && there != crossing && !crossings_.lies_in(crossing, there)) mark(leaf);
  there = crossing;
}

void Conforming::check_face(const MinimalFace& face) {
  const SurfaceLeaf& owner = leaves_.leaves()[face.of_above ? face.above : face.below];
  int crossings = 0;
  for (const int side : cell_face(face.axis, face.of_above ? 0 : 1).sides)
    crossings += owner.sides[side] != no_index;
  if (crossings <= 2) return;
  mark(face.below);
  mark(face.above);
}

bool Conforming::close_loops(Progress& progress) {
  const std::size_t count = leaves_.leaves().size();
  std::vector<std::vector<std::uint32_t>> tasks((count + leaves_a_task - 1) / leaves_a_task);
  std::vector<std::vector<std::uint32_t>> crowded(tasks.size());
  first_start_.assign(count + 1, 0);
  for_chunks(count, leaves_a_task, [&](std::size_t first, std::size_t end) {
    if (!progress.poll()) return;
    std::vector<std::uint32_t> starts;
    for (std::size_t i = first; i < end; ++i) {
      if (curves_.pieces(static_cast<std::uint32_t>(i)).empty()) continue;
      curves_.loops(static_cast<std::uint32_t>(i), starts);
      if (starts.size() > 2) crowded[first / leaves_a_task].push_back(static_cast<std::uint32_t>(i));
      first_start_[i] = static_cast<std::uint32_t>(starts.size());
      std::vector<std::uint32_t>& all = tasks[first / leaves_a_task];
      all.insert(all.end(), starts.begin(), starts.end());
    }
  });
  if (progress.cancelled()) return false;
  for (const std::vector<std::uint32_t>& task : crowded) {
    for (const std::uint32_t leaf : task) mark(leaf);
  }
  starts_.clear();
  for (const std::vector<std::uint32_t>& task : tasks)
    starts_.insert(starts_.end(), task.begin(), task.end());
  std::uint32_t total = 0;
  for (std::uint32_t& first : first_start_) total += std::exchange(first, total);
  return true;
}

}  // namespace cdfr
