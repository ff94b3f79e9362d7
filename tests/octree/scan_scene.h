/// Leaves' lists made by hand, over groups that need no mesh.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "geometry/scan_cases.h"
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

/// Groups, a leaf's list over them, and the leaf's centre.
struct Scene {
  std::vector<ShapedGroup> groups;
  std::vector<ScanGroup> scan_groups;
  std::vector<Entry> list;
  Vec3 centre;

  DoubleDouble squared(const Vec3& p, std::uint32_t slot) const {
    return measure(p, groups[slot / group_size].shapes[slot % group_size]).squared;
  }

  void add(const ShapedGroup& made, std::uint8_t lanes) {
    const auto number = static_cast<std::uint32_t>(groups.size());
    groups.push_back(made);
    scan_groups.push_back(scan_group(made.group, origin, edge));
    double least = HUGE_VAL;
    for (std::uint32_t lane = 0; lane < group_size; ++lane) {
      if ((lanes >> lane & 1U) == 0) continue;
      least = std::min(least, square_root(squared(centre, number * std::uint32_t{group_size} + lane)) / edge);
    }
    list.push_back(Entry::of_group(number, least * (1 - 0x1p-50), lanes));
    std::sort(list.begin(), list.end());
  }

  /// cdfr::scan of the list.
  bool scan(const Vec3& p, Candidates& candidates) const {
    const Vec3 a = in_edges(p), b = in_edges(centre);
    const double from_centre = std::hypot(a.x - b.x, a.y - b.y, a.z - b.z) * (1 + 0x1p-48) + 0x1p-48;
    return cdfr::scan(scan_groups.data(), list, a, from_centre, candidates);
  }
};

}  // namespace cdfr::test
