/// Leaves' lists made by hand, over groups that need no mesh.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "geometry/box_distance.h"
#include "geometry/scan_cases.h"
#include "mesh/bvh.h"
#include "octree/scan.h"

namespace cdfr::test {

/// Of the lattice; its brick has eight edges along each axis.
inline constexpr Vec3 origin{-2, 6, 0.5};
inline constexpr double edge = 0.5;

inline Vec3 in_edges(const Vec3& p) {
  return {(p.x - origin.x) / edge, (p.y - origin.y) / edge, (p.z - origin.z) / edge};
}

inline Vec3 anywhere(test::Random& random, double inset = 0) {
  const double far = 8 * edge - inset;
  return random.in({{origin.x + inset, origin.y + inset, origin.z + inset},
                    {origin.x + far, origin.y + far, origin.z + far}});
}

/// Groups, a leaf's list over them, and the leaf's centre. With a size, in edges, entries are bounded in the
/// leaf, and points have to lie in it.
struct Scene {
  std::vector<ShapedGroup> groups;
  std::vector<ScanGroup> scan_groups;
  std::vector<Entry> list;
  Bvh bvh;
  Vec3 centre;
  double size = 0;

  DoubleDouble squared(const Vec3& p, std::uint32_t slot) const {
    return measure(p, groups[slot / group_size].shapes[slot % group_size]).squared;
  }

  void add(const ShapedGroup& made, std::uint8_t lanes) {
    const auto number = static_cast<std::uint32_t>(groups.size());
    groups.push_back(made);
    scan_groups.push_back(scan_group(made.group, origin, edge));
    const double least = std::sqrt(least_squared(centre, number, lanes));
    list.push_back(Entry::of_group(number, least, lanes, bound(number, least, lanes)));
    std::sort(list.begin(), list.end());
  }

  Vec3 corner(std::size_t number) const {
    const auto at = [&](double middle, std::size_t axis) {
      return middle + ((number >> axis & 1U) != 0 ? 0.5 : -0.5) * size * edge;
    };
    return {at(centre.x, 0), at(centre.y, 1), at(centre.z, 2)};
  }

  /// A binary tree over all groups, whose node 0 may then stand in the list for any of them.
  void grow_tree() {
    std::vector<BvhNode> nodes;
    grow_tree(nodes, 0, static_cast<std::uint32_t>(groups.size()));
    bvh.nodes = std::move(nodes);
  }

  /// cdfr::scan of the list. False if that does not find all.
  bool scan(const Vec3& p, Candidates& candidates) const {
    TriangleStore triangles;
    triangles.records = std::vector<TriangleRecord>(groups.size() * group_size);
    Lattice lattice;
    lattice.origin = origin;
    lattice.edge = edge;
    lattice.bricks = {8, 8, 8};
    const Vec3 a = in_edges(p), b = in_edges(centre);
    Located leaf;
    leaf.entries = list;
    leaf.offset = {a.x - b.x, a.y - b.y, a.z - b.z};
    leaf.from_centre = std::hypot(leaf.offset.x, leaf.offset.y, leaf.offset.z) * (1 + 0x1p-48) + 0x1p-48;
    leaf.size = size;
    Shortlist shortlist;
    shorten(scan_groups.data(), leaf, shortlist);
    cdfr::scan({triangles, scan_groups.data(), bvh, lattice}, p, a, leaf, shortlist, candidates);
    return candidates.complete;
  }

 private:
  void grow_tree(std::vector<BvhNode>& nodes, std::uint32_t first, std::uint32_t end) const {
    const std::size_t place = nodes.size();
    BvhNode node{{groups[first].group.vertex(0, 0), groups[first].group.vertex(0, 0)}, first, end};
    for (std::uint32_t g = first; g < end; ++g) {
      for (const TriangleShape& shape : groups[g].shapes) {
        for (const Vec3& v : shape.vertices) node.box = united(node.box, {v, v});
      }
    }
    nodes.push_back(node);
    if (node.is_group()) return;
    const std::uint32_t middle = first + (end - first) / 2;
    grow_tree(nodes, first, middle);
    grow_tree(nodes, middle, end);
    nodes[place] = node;
  }

  /// In edges, rounded down.
  double least_squared(const Vec3& p, std::uint32_t number, std::uint8_t lanes) const {
    double least = HUGE_VAL;
    for (std::uint32_t lane = 0; lane < group_size; ++lane) {
      if ((lanes >> lane & 1U) == 0) continue;
      least = std::min(least, squared(p, number * std::uint32_t{group_size} + lane).hi);
    }
    return least / (edge * edge) * (1 - 0x1p-50);
  }

  EntryBound bound(std::uint32_t number, double least, std::uint8_t lanes) const {
    if (size == 0) return {};
    std::array<double, 8> corners;
    for (std::size_t k = 0; k < 8; ++k) corners[k] = least_squared(corner(k), number, lanes);
    return entry_bound(corners, double{Entry::kept(least)}, size);
  }
};

}  // namespace cdfr::test
