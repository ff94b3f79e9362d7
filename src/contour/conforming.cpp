#include "contour/conforming.h"

#include <algorithm>

#include "contour/cell_walk.h"
#include "core/parallel.h"

namespace cdfr {
namespace {

constexpr std::size_t leaves_a_task = 256;

}  // namespace

bool Conforming::run(Progress& progress) {
  for (;;) {
    walk();
    mark_crowded_faces();
    curves_.collect(faces_);
    if (!close_loops(progress)) return false;
    std::vector<std::uint32_t> split;
    for (std::uint32_t i = 0; i < marked_.size(); ++i) {
      if (marked_[i]) split.push_back(i);
    }
    if (split.empty()) return true;
    if (!leaves_.split(split, progress)) return false;
  }
}

void Conforming::mark(std::uint32_t leaf) {
  if (leaves_.level(leaves_.leaves()[leaf]) < leaves_.octree().lattice().deepest) marked_[leaf] = 1;
}

void Conforming::walk() {
  for (SurfaceLeaf& leaf : leaves_.leaves()) leaf.sides.fill(no_index);
  marked_.assign(leaves_.leaves().size(), 0);
  faces_.clear();
  const std::vector<SurfaceCell>& cells = leaves_.octree().cells();
  const auto on_edge = [this](unsigned axis, const std::array<std::uint32_t, 4>& around) {
    cross(axis, around);
  };
  const auto on_face = [&](unsigned axis, std::uint32_t below, std::uint32_t above) {
    faces_.push_back({cells[below].leaf, cells[above].leaf, static_cast<std::uint8_t>(axis), 0,
                      cells[above].level > cells[below].level});
  };
  CellWalk(cells, on_edge, on_face).run();
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
  const std::uint32_t crossing =
      crossings_.number(static_cast<int>(axis), leaf.corners[low], leaf.corners[high]);
  for (std::size_t i = 0; i < 4; ++i) {
    if (around[i] == around[i ^ 1] || around[i] == around[i ^ 2]) continue;  // in the middle of its face
    std::uint32_t& side = leaves_.leaves()[cells[around[i]].leaf].sides[side_at(i)];
    if (side != no_index) mark(cells[around[i]].leaf);
    side = crossing;
  }
}

void Conforming::mark_crowded_faces() {
  for (const MinimalFace& face : faces_) {
    const SurfaceLeaf& owner = leaves_.leaves()[face.of_above ? face.above : face.below];
    const CellFace on_owner = cell_face(face.axis, face.of_above ? 0 : 1);
    int crossings = 0;
    for (const int side : on_owner.sides) crossings += owner.sides[side] != no_index;
    if (crossings <= 2) continue;
    mark(face.below);
    mark(face.above);
  }
}

bool Conforming::close_loops(Progress& progress) {
  const std::size_t count = leaves_.leaves().size();
  std::vector<std::vector<std::uint32_t>> tasks((count + leaves_a_task - 1) / leaves_a_task);
  first_start_.assign(count + 1, 0);
  for_chunks(count, leaves_a_task, [&](std::size_t first, std::size_t end) {
    if (!progress.poll()) return;
    std::vector<std::uint32_t> starts;
    for (std::size_t i = first; i < end; ++i) {
      if (curves_.pieces(static_cast<std::uint32_t>(i)).empty()) continue;
      curves_.loops(static_cast<std::uint32_t>(i), starts);
      if (starts.size() > 2) mark(static_cast<std::uint32_t>(i));
      first_start_[i] = static_cast<std::uint32_t>(starts.size());
      std::vector<std::uint32_t>& all = tasks[first / leaves_a_task];
      all.insert(all.end(), starts.begin(), starts.end());
    }
  });
  if (progress.cancelled()) return false;
  starts_.clear();
  for (const std::vector<std::uint32_t>& task : tasks)
    starts_.insert(starts_.end(), task.begin(), task.end());
  std::uint32_t total = 0;
  for (std::uint32_t& first : first_start_) total += std::exchange(first, total);
  return true;
}

}  // namespace cdfr
