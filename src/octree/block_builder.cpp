#include "octree/block_builder.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/box_distance.h"
#include "geometry/triangle_box.h"

namespace cdfr {

bool BlockBuilder::may_split(const OpenCell& cell) const noexcept {
  return cell.cell.level < options_.max_level &&
         cell.triangles > static_cast<std::uint64_t>(options_.max_triangles_per_leaf);
}

bool BlockBuilder::pays(const OpenCell& cell, const std::array<OpenCell, 8>& children) const noexcept {
  if (options_.gain >= 1) return true;
  std::uint64_t sum = 0;
  for (const OpenCell& child : children) sum += child.triangles;
  return static_cast<double>(sum) <= 8 * options_.gain * static_cast<double>(cell.triangles);
}

void BlockBuilder::count(const OpenCell& cell, std::uint64_t inherited) {
  const auto level = static_cast<std::size_t>(cell.cell.level);
  if (levels_.size() <= level) levels_.resize(level + 1);
  levels_[level].cells += 1;
  levels_[level].entries_in += inherited;
  levels_[level].entries_kept += cell.triangles;
  levels_[level].entries_pruned += inherited - cell.triangles;
}

/// No triangle is closer to the cell's centre.
double BlockBuilder::away(const OpenCell& cell) const noexcept {
  const double slack = 4 * estimate_error * lattice_.reach();
  return distance_between(lattice_.centre(cell.cell), cell.dominators[0]) - slack;
}

bool BlockBuilder::is_left_out(const OpenCell& cell, bool is_free) const {
  return left_out_ && left_out_(cell.cell, away(cell), is_free);
}

/// The closed grown cell, from which queries may come.
Box BlockBuilder::grown_box(const Cell& cell) const noexcept {
  const double g = lattice_.grown();
  const Box exact = lattice_.box(cell);
  return {{exact.lo.x - g, exact.lo.y - g, exact.lo.z - g}, {exact.hi.x + g, exact.hi.y + g, exact.hi.z + g}};
}

/// Is it certain without a look at the triangles that none comes in?
bool BlockBuilder::is_far(const OpenCell& cell) const noexcept {
  return away(cell) > diagonal_above(grown_box(cell.cell)) / 2;
}

/// Does the surface come in? True where rounding leaves it open.
bool BlockBuilder::may_cross(const OpenCell& cell) const {
  if (is_far(cell)) return false;
  const Box box = grown_box(cell.cell);
  const auto enter = [&](std::uint32_t index) { return overlap(space_.bvh.nodes[index].box, box); };
  const auto misses = [&](std::uint32_t index) {
    const std::uint32_t number = space_.bvh.nodes[index].first_group;
    const std::uint32_t first = number * std::uint32_t{group_size};
    for (std::uint32_t slot = first; slot < first + space_.triangles.lanes(number); ++slot) {
      if (may_touch(space_.triangles.shape(slot).vertices, box)) return false;
    }
    return true;
  };
  return !std::all_of(cell.list.begin(), cell.list.end(),
                      [&](const Candidate& c) { return walk(space_.bvh, c.node, enter, misses); });
}

void BlockBuilder::close(Growing&& cell) {
  const bool crossed = may_cross(cell.open);
  if (!crossed && is_left_out(cell.open, true)) return leave_out(cell);
  add_leaf(cell, crossed, listed(cell.open.list));
}

void BlockBuilder::leave_out(const Growing& cell) {
  const bool is_group = space_.bvh.nodes[0].is_group();
  add_leaf(cell, false,
           {is_group ? Entry::of_group(0, 0, space_.triangles.own_lanes(0)) : Entry::of_node(0, 0)});
}

void BlockBuilder::add_leaf(const Growing& cell, bool crossed, std::vector<Entry> list) {
  nodes_[cell.node] = TreeNode::leaf(static_cast<std::uint32_t>(lists_.size()));
  crossed_.push_back(crossed);
  levels_[static_cast<std::size_t>(cell.open.cell.level)].leaves += 1;
  lists_.push_back(std::move(list));
}

/// Ascending.
std::vector<Entry> BlockBuilder::listed(const std::vector<Candidate>& candidates) const {
  std::vector<Entry> list;
  list.reserve(candidates.size());
  for (const Candidate& c : candidates) {
    const BvhNode& node = space_.bvh.nodes[c.node];
    list.push_back(node.is_group() ? Entry::of_group(node.first_group, c.distance, c.lanes, c.bound)
                                   : Entry::of_node(c.node, c.distance, c.bound));
  }
  std::sort(list.begin(), list.end());
  return list;
}

/// Numbers leaves along the Morton curve and puts their lists one after another.
Block BlockBuilder::laid_out(std::uint64_t key) {
  std::vector<LeafRecord> leaves;
  std::vector<Entry> entries;
  leaves.reserve(lists_.size());
  std::vector<std::uint32_t> stack{0};
  while (!stack.empty()) {
    TreeNode& node = nodes_[stack.back()];
    stack.pop_back();
    if (!node.is_leaf()) {
      for (std::uint32_t child = 8; child-- > 0;) stack.push_back(node.first_child() + child);
      continue;
    }
    const std::uint32_t closed = node.leaf_number();
    const std::vector<Entry>& list = lists_[closed];
    LeafRecord leaf;
    leaf.first = static_cast<std::uint32_t>(entries.size());
    leaf.set(static_cast<std::uint32_t>(list.size()), crossed_[closed] ? Side::surface : Side::undecided);
    node = TreeNode::leaf(static_cast<std::uint32_t>(leaves.size()));
    leaves.push_back(leaf);
    entries.insert(entries.end(), list.begin(), list.end());
  }
  return {key, std::move(nodes_), std::move(leaves), std::move(entries)};
}

Block BlockBuilder::build(OpenCell root, std::uint64_t inherited) {
  const std::uint64_t key = key_of(root.cell);
  nodes_.resize(1);
  count(root, inherited);
  std::vector<Growing> frontier;
  frontier.push_back({std::move(root), 0});
  while (!frontier.empty() && !progress_.cancelled()) {
    std::vector<Growing> next;
    std::uint64_t leaves = lists_.size() + frontier.size();  // if nothing splits from here on
    if (leaves + 7 * frontier.size() > most_leaves_) {
      std::stable_sort(frontier.begin(), frontier.end(), [](const Growing& a, const Growing& b) {
        return a.open.triangles > b.open.triangles;
      });
    }
    for (Growing& cell : frontier) {
      if (!progress_.poll()) return {};
      if (is_far(cell.open) && is_left_out(cell.open, true)) {
        leave_out(cell);
        continue;
      }
      if (!may_split(cell.open) || leaves + 7 > most_leaves_) {
        close(std::move(cell));
        continue;
      }
      std::array<OpenCell, 8> children = refine(space_, lattice_, cell.open, refining_, scratch_);
      if (!pays(cell.open, children)) {
        close(std::move(cell));
        continue;
      }
      leaves += 7;
      const auto first = static_cast<std::uint32_t>(nodes_.size());
      nodes_[cell.node] = TreeNode::inner(first);
      nodes_.resize(first + 8);
      for (std::uint32_t child = 0; child < 8; ++child) {
        count(children[child], cell.open.triangles);
        next.push_back({std::move(children[child]), first + child});
      }
      cell.open = {};
    }
    frontier = std::move(next);
  }
  if (!frontier.empty()) return {};  // cancelled
  return laid_out(key);
}

}  // namespace cdfr
