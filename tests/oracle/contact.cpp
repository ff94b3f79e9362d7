#include "oracle/contact.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

#include "oracle/exact_distance.h"

namespace cdfr::oracle {
namespace {

struct Nearest {
  std::array<Vec3, 3> corners;
  Exact exact;
};

std::vector<Nearest> all_nearest(MeshView mesh, Vec3 p, std::span<const std::uint32_t> candidates) {
  std::vector<Nearest> result;
  for (const std::uint32_t number : candidates) {
    const Triangle& t = mesh.triangles[number];
    const std::array<Vec3, 3> v{mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]};
    Exact exact = exact_distance(p, v[0], v[1], v[2]);
    const int order = result.empty() ? 0 : compare(exact.squared, result.front().exact.squared);
    if (order < 0) result.clear();
    if (order <= 0) result.push_back({v, std::move(exact)});
  }
  return result;
}

bool same_foot(const Exact& a, const Exact& b) {
  return compare(a.foot[0], b.foot[0]) == 0 && compare(a.foot[1], b.foot[1]) == 0 &&
         compare(a.foot[2], b.foot[2]) == 0;
}

/// The foot is the only point of a triangle at its distance, so it lies on what the triangles have in common
/// if that is at the same distance.
bool meet_at_foot(Vec3 p, const Nearest& a, const Nearest& b) {
  std::vector<Vec3> common;
  std::ranges::copy_if(a.corners, std::back_inserter(common),
                       [&](const Vec3& v) { return std::ranges::find(b.corners, v) != b.corners.end(); });
  if (common.empty() || common.size() == 3) return false;
  const Exact shared = exact_distance(p, common.front(), common.back(), common.back());
  return compare(shared.squared, a.exact.squared) == 0;
}

}  // namespace

bool touches_itself(MeshView mesh, Vec3 p, std::span<const std::uint32_t> candidates) {
  const std::vector<Nearest> nearest = all_nearest(mesh, p, candidates);
  for (std::size_t i = 0; i < nearest.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (same_foot(nearest[i].exact, nearest[j].exact) && !meet_at_foot(p, nearest[i], nearest[j]))
        return true;
    }
  }
  return false;
}

}  // namespace cdfr::oracle
