#include "field/stats.h"

#include <xxhash.h>

#include <algorithm>
#include <array>
#include <memory>

#include "field/domain.h"
#include "field/leaves.h"
#include "octree/search.h"

namespace cdfr {
namespace {

/// Length of a list in triangles.
std::uint64_t length_of(const FieldData& field, const Block& block, const LeafRecord& leaf) noexcept {
  std::uint64_t length = 0;
  for (std::uint32_t i = leaf.first; i < leaf.first + leaf.count(); ++i) {
    const Entry& entry = block.entries[i];
    if (entry.is_group()) {
      length += static_cast<std::uint64_t>(std::popcount(entry.lanes()));
    } else {
      const auto [first, end] = groups_of(field.bvh, entry);
      length += std::min<std::uint64_t>(std::uint64_t{end} * group_size, field.triangles.size()) -
                std::uint64_t{first} * group_size;
    }
  }
  return length;
}

}  // namespace

std::uint64_t total_bytes(const FieldData& field) noexcept {
  const Octree& tree = field.tree;
  const WindingTree& winding = field.winding;
  return sizeof field + field.triangles.exact.bytes() + field.triangles.records.bytes() +
         field.bvh.nodes.bytes() + field.pseudonormals.edges.bytes() + field.pseudonormals.vertices.bytes() +
         winding.nodes.bytes() + winding.boundary.edges.bytes() + winding.boundary.first.bytes() +
         winding.boundary.lengths.bytes() + tree.top.bytes() + tree.nodes.bytes() + tree.leaves.bytes() +
         tree.entries.bytes() + tree.starts.bytes() + tree.levels.size() * sizeof(LevelStats) +
         field.index.bytes() + field.leaf_windings.bytes() + field.scan_groups.bytes();
}

std::vector<std::uint32_t> slots_of(const FieldData& field, const Block& block, const LeafRecord& leaf) {
  std::vector<std::uint32_t> slots;
  for (std::uint32_t i = leaf.first; i < leaf.first + leaf.count(); ++i) {
    const Entry& entry = block.entries[i];
    const auto [first, end] = groups_of(field.bvh, entry);
    for (std::uint32_t group = first; group < end; ++group) {
      for (std::uint32_t lane = 0; lane < field.triangles.lanes(group); ++lane) {
        if ((entry.lanes() >> lane & 1U) != 0)
          slots.push_back(group * static_cast<std::uint32_t>(group_size) + lane);
      }
    }
  }
  return slots;
}

Stats stats_of(const FieldData& field) {
  Stats stats;
  stats.triangles = field.triangles.size();
  stats.vertices = field.report.vertices;
  stats.levels = field.tree.levels;
  stats.bytes = total_bytes(field);
  std::vector<std::uint64_t> lengths;
  std::vector<std::uint64_t> by_level(stats.levels.size());
  for (std::size_t i = 0; i < field.tree.block_count(); ++i) {
    const Block block = field.tree.block(i);
    stats.entries += block.entries.size();
    for_each_leaf(block, [&](const Cell& cell, std::uint32_t number) {
      const LeafRecord& leaf = block.leaves[number];
      if (is_left_out(field, block, leaf)) return;
      lengths.push_back(length_of(field, block, leaf));
      const auto level = static_cast<std::size_t>(cell.level);
      if (level < by_level.size()) by_level[level] += lengths.back();  // deeper in forged files alone
      stats.inside_leaves += leaf.side() == Side::inside;
      stats.surface_leaves += leaf.side() == Side::surface;
      stats.outside_leaves += leaf.side() == Side::outside;
      stats.undecided_leaves += leaf.side() == Side::undecided;
    });
  }
  for (std::size_t level = 0; level < stats.levels.size(); ++level) {
    LevelStats& l = stats.levels[level];
    if (l.leaves > 0) l.mean_list = static_cast<double>(by_level[level]) / static_cast<double>(l.leaves);
  }
  if (lengths.empty()) return stats;
  std::sort(lengths.begin(), lengths.end());
  std::uint64_t sum = 0;
  for (const std::uint64_t length : lengths) sum += length;
  stats.mean_list = static_cast<double>(sum) / static_cast<double>(lengths.size());
  stats.p95_list = static_cast<double>(lengths[(lengths.size() - 1) * 95 / 100]);
  stats.max_list = lengths.back();
  return stats;
}

std::uint64_t checksum_of(const FieldData& field) {
  const std::unique_ptr<XXH64_state_t, decltype(&XXH64_freeState)> state(XXH64_createState(),
                                                                         &XXH64_freeState);
  XXH64_reset(state.get(), 0);
  for (const TriangleRecord& record : field.triangles.records) {
    XXH64_update(state.get(), &record.number, sizeof record.number);
  }
  for (std::size_t i = 0; i < field.tree.block_count(); ++i) {
    const Block block = field.tree.block(i);
    for_each_leaf(block, [&](const Cell& cell, std::uint32_t number) {
      const LeafRecord& leaf = block.leaves[number];
      const std::array<std::uint64_t, 2> head{key_of(cell), leaf.count_and_side};
      XXH64_update(state.get(), head.data(), sizeof head);
      XXH64_update(state.get(), block.entries.data() + leaf.first, leaf.count() * sizeof(Entry));
    });
  }
  return XXH64_digest(state.get());
}

}  // namespace cdfr
