#include "store/file_check.h"

#include <xxhash.h>

#include <algorithm>
#include <cmath>

#include "core/array.h"
#include "geometry/query_range.h"

namespace cdfr {
namespace {

using Element = std::uint64_t;

/// good(i) for all of them.
template <class Good>
bool all_of(Element first, Element end, Good good) noexcept {
  for (Element i = first; i < end; ++i) {
    if (!good(i)) return false;
  }
  return true;
}

bool good_coordinate(double x) noexcept {
  const double size = std::fabs(x);
  return size == 0 || (size >= smallest_coordinate && size <= largest_coordinate);
}

bool good_triangle(const ExactTriangle& t) noexcept {
  for (const Vec3& v : t.shape.vertices) {
    if (!good_coordinate(v.x) || !good_coordinate(v.y) || !good_coordinate(v.z)) return false;
  }
  return true;
}

/// Of a tree's array: children come after their parents.
bool good_node(const TreeNode& node, Element number, Element nodes, Element leaves) noexcept {
  if (node.is_leaf()) return node.leaf_number() < leaves;
  return node.first_child() > number && Element{node.first_child()} + 8 <= nodes;
}

/// The children of a node of the BVH share its groups, and lie where it says.
bool good_bvh_node(const BvhNode* nodes, Element i, Element count, Element groups) noexcept {
  const BvhNode& n = nodes[i];
  if (n.first_group >= n.end_group || n.end_group > groups) return false;
  if (n.is_group()) return true;
  if (i + 2 * Element{n.groups()} - 1 > count) return false;
  const BvhNode& left = nodes[i + 1];
  if (left.first_group != n.first_group || left.end_group <= n.first_group || left.end_group >= n.end_group)
    return false;
  const BvhNode& right = nodes[i + 2 * Element{left.groups()}];
  return right.first_group == left.end_group && right.end_group == n.end_group;
}

template <class T>
void fill_with(std::byte* at, std::size_t bytes, std::size_t skipped, const T& value) noexcept {
  const auto* pattern = reinterpret_cast<const std::byte*>(&value);
  for (std::size_t i = 0; i < bytes; ++i) at[i] = pattern[(skipped + i) % sizeof(T)];
}

}  // namespace

FileCheck::FileCheck(std::span<const std::byte> bytes, const format::Counts& counts)
    : bytes_(bytes), counts_(counts), places_(counts) {}

bool FileCheck::sums_up(std::size_t first, std::size_t end) const noexcept {
  const std::size_t data_end = places_.at[format::checksums];
  if (first >= data_end) return true;
  const std::uint64_t sum = XXH64(bytes_.data() + first, std::min(end, data_end) - first, 0);
  return elements<std::uint64_t>(format::checksums)[first / GuardedMap::block_size] == sum;
}

bool FileCheck::in_bounds(format::Section section, Element first, Element end) const noexcept {
  const auto count = [&](format::Section s) { return counts_[s]; };
  // Of blocks that are not looked at yet the starts may be anything: they are compared, and used for nothing.
  const auto* starts = elements<BlockStart>(format::block_starts);
  const Element blocks = std::max<Element>(count(format::block_starts), 1) - 1;
  const BlockStart* starts_end = starts + count(format::block_starts);
  const auto next_start = [&](Element BlockStart::*place, Element i) {
    if (blocks == 0) return starts_end;
    return std::upper_bound(starts + 1, starts_end, i,
                            [&](Element n, const BlockStart& s) { return n < s.*place; });
  };
  switch (section) {
    case format::top: {
      const auto* nodes = elements<TreeNode>(section);
      return all_of(first, end, [&](Element i) {
        return (nodes[i].is_leaf() && nodes[i].leaf_number() == Octree::no_block) ||
               good_node(nodes[i], i, count(section), blocks);
      });
    }
    case format::block_starts:
      return all_of(first, end, [&](Element i) {
        const BlockStart& s = starts[i];
        if (i == 0 && (s.node != 0 || s.leaf != 0 || s.entry != 0)) return false;
        if (i == blocks) {
          return s.node == count(format::block_nodes) && s.leaf == count(format::block_leaves) &&
                 s.entry == count(format::entries);
        }
        return s.node < starts[i + 1].node && s.leaf < starts[i + 1].leaf && s.entry < starts[i + 1].entry;
      });
    case format::index_grid: {
      const auto* nodes = elements<TreeNode>(section);
      return all_of(first, end, [&](Element i) {
        return nodes[i].is_leaf() ? nodes[i].leaf_number() < count(format::index_leaves)
                                  : Element{nodes[i].first_child()} + 8 <= count(format::index_nodes);
      });
    }
    case format::index_nodes: {
      const auto* nodes = elements<TreeNode>(section);
      return all_of(first, end, [&](Element i) {
        return good_node(nodes[i], i, count(section), count(format::index_leaves));
      });
    }
    case format::index_leaves: {
      const auto* leaves = elements<LeafIndex::Leaf>(section);
      return all_of(first, end, [&](Element i) {
        const Element entries = leaves[i].count_and_side >> 2;
        return entries > 0 && entries <= count(format::entries) &&
               leaves[i].first <= count(format::entries) - entries && leaves[i].level <= deepest_level;
      });
    }
    case format::entries: {
      const auto* entries = elements<Entry>(section);
      return all_of(first, end, [&](Element i) {
        const Element number = entries[i].number();
        if (!entries[i].is_group()) return number < count(format::bvh_nodes);
        const Element triangles = count(format::records);
        if (number >= count(format::scan_groups) || number * group_size >= triangles) return false;
        const Element left = triangles - number * group_size;
        return left >= group_size || entries[i].lanes() >> left == 0;
      });
    }
    case format::triangles: {
      const auto* triangles = elements<ExactTriangle>(section);
      return all_of(first, end, [&](Element i) { return good_triangle(triangles[i]); });
    }
    case format::records: {
      const auto* records = elements<TriangleRecord>(section);
      const auto* triangles = elements<ExactTriangle>(format::triangles);
      const bool is_signed = count(format::vertex_normals) > 0;
      return all_of(first, end, [&](Element i) {
        const TriangleRecord& r = records[i];
        bool good = r.number < count(section);
        for (std::size_t k = 0; k < 3 && is_signed; ++k) {
          // A query on an edge looks up its normal; only one that is no edge has none.
          const auto& corners = triangles[i].shape.vertices;
          const bool is_edge = !(corners[k] == corners[(k + 1) % 3]);
          good = good && r.vertices[k] < count(format::vertex_normals) &&
                 (r.edges[k] == no_index ? !is_edge : r.edges[k] < count(format::edge_normals));
        }
        return good;
      });
    }
    case format::bvh_nodes: {
      const auto* nodes = elements<BvhNode>(section);
      return all_of(first, end, [&](Element i) {
        return good_bvh_node(nodes, i, count(section), count(format::scan_groups));
      });
    }
    case format::block_nodes: {
      const auto* nodes = elements<TreeNode>(section);
      const BlockStart* next = next_start(&BlockStart::node, first);
      return all_of(first, end, [&](Element i) {
        while (next != starts_end && next->node <= i) ++next;
        if (next == starts_end) return false;
        const BlockStart& own = next[-1];
        return good_node(nodes[i], i - own.node, next->node - own.node, next->leaf - own.leaf);
      });
    }
    case format::block_leaves: {
      const auto* leaves = elements<LeafRecord>(section);
      const BlockStart* next = next_start(&BlockStart::leaf, first);
      return all_of(first, end, [&](Element i) {
        while (next != starts_end && next->leaf <= i) ++next;
        return next != starts_end && leaves[i].count() > 0 &&
               Element{leaves[i].first} + leaves[i].count() <= next->entry - next[-1].entry;
      });
    }
    case format::winding_places: {
      const auto* places = elements<std::uint32_t>(section);
      return all_of(first, end, [&](Element i) {
        return places[i] == no_index || Element{places[i]} + 1 < count(format::known_windings);
      });
    }
    case format::known_windings: {
      const auto* known = elements<LeafWindings::Known>(section);
      return all_of(first, end, [&](Element i) { return known[i].first <= count(format::near_edges); });
    }
    case format::near_edges: {
      const auto* near = elements<std::uint32_t>(section);
      return all_of(first, end, [&](Element i) { return near[i] < count(format::boundary_edges); });
    }
    case format::boundary_edges: {
      const auto* edges = elements<BoundaryEdge>(section);
      const double most = 3 * static_cast<double>(count(format::triangles));
      return all_of(first, end, [&](Element i) { return edges[i].times >= 1 && edges[i].times <= most; });
    }
    case format::boundary_first: {
      const auto* edges = elements<std::uint32_t>(section);
      return all_of(first, end, [&](Element i) { return edges[i] <= count(format::boundary_edges); });
    }
    default:
      return true;  // no number in it is an index
  }
}

bool FileCheck::good(std::size_t first, std::size_t end) const noexcept {
  if (!sums_up(first, end)) return false;
  for (std::size_t s = 0; s < format::checksums; ++s) {
    const std::uint64_t size = format::element_size[s];
    const std::uint64_t from = places_.at[s], to = from + counts_[s] * size;
    if (from >= end || to <= first) continue;
    const Element begin = first > from ? (first - from) / size : 0;
    const Element last = (std::min<std::uint64_t>(end, to) - from + size - 1) / size;
    if (!in_bounds(static_cast<format::Section>(s), begin, last)) return false;
  }
  return true;
}

void FileCheck::fill(std::size_t first, std::size_t end, std::byte* into) const noexcept {
  const auto fill_section = [&](format::Section s, const auto& value) {
    const std::uint64_t from = std::max<std::uint64_t>(first, places_.at[s]);
    const std::uint64_t to = std::min<std::uint64_t>(end, places_.at[s] + counts_[s] * sizeof value);
    if (from < to) fill_with(into + (from - first), to - from, from - places_.at[s], value);
  };
  for (const format::Section s : {format::top, format::index_grid, format::index_nodes, format::block_nodes})
    fill_section(s, TreeNode::leaf(0));
  fill_section(format::index_leaves, LeafIndex::Leaf{0, 1U << 2 | static_cast<unsigned>(Side::surface), 0});
  fill_section(format::entries, Entry::of_group(0, 0, 1));
  fill_section(format::bvh_nodes, BvhNode{{}, 0, 1});
  fill_section(format::winding_places, no_index);
}

std::size_t FileCheck::first_bad() const noexcept {
  for (std::size_t first = 0; first < bytes_.size(); first += GuardedMap::block_size) {
    if (!good(first, std::min(first + GuardedMap::block_size, bytes_.size()))) return first;
  }
  return bytes_.size();
}

std::string FileCheck::place_text(std::size_t where) const {
  const auto place = [this](std::size_t at) {
    std::size_t s = format::section_count;
    while (s > 0 && places_.at[s - 1] > at) --s;
    if (s == 0) return std::string("head");
    const std::uint64_t element = (at - places_.at[s - 1]) / format::element_size[s - 1];
    return std::string(format::section_name[s - 1]) + " element " + std::to_string(element);
  };
  const std::size_t end = std::min(where + GuardedMap::block_size, bytes_.size());
  return place(where) + " to " + place(end - 1);
}

}  // namespace cdfr
