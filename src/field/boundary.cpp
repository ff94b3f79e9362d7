#include "field/boundary.h"

#include <cmath>
#include <cstdlib>
#include <limits>

#include "geometry/box_distance.h"
#include "geometry/solid_angle.h"

namespace cdfr {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
/// Covers the roundings of a few positive terms.
constexpr double up = 1 + 0x1p-40;
/// No winding number that is worth deciding drifts more.
constexpr double hopeless = 1024;
constexpr int most_halvings = 8;

/// By edge id: how often triangles run along it from the low vertex to the high one, less the other way.
std::vector<std::int32_t> balances(const TriangleStore& store, std::size_t edge_count) {
  std::vector<std::int32_t> balance(edge_count);
  for (const TriangleRecord& record : store.records) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (record.edges[k] == no_index) continue;
      balance[record.edges[k]] += record.vertices[k] < record.vertices[(k + 1) % 3] ? 1 : -1;
    }
  }
  return balance;
}

/// L / gap^2 of a piece of edge, cut until pieces are shorter than their gap from the ball.
double pull(const Vec3& a, const Vec3& b, const Vec3& centre, double radius, int halvings) noexcept {
  const Vec3 middle{a.x + (b.x - a.x) / 2, a.y + (b.y - a.y) / 2, a.z + (b.z - a.z) / 2};
  const double length = distance_between(a, b) * up;
  const double gap = distance_between(centre, middle) * (1 - 0x1p-40) - length / 2 - radius;
  if (gap > length || (halvings == 0 && gap > 0)) return length / gap / gap;
  if (halvings == 0) return infinity;
  return pull(a, middle, centre, radius, halvings - 1) + pull(middle, b, centre, radius, halvings - 1);
}

}  // namespace

Boundary find_boundary(SearchSpace space, std::size_t edge_count) {
  std::vector<std::int32_t> balance = balances(space.triangles, edge_count);
  Boundary boundary;
  const std::size_t groups = space.triangles.group_count();
  std::vector<double> group_length(groups);
  for (std::uint32_t slot = 0; slot < space.triangles.size(); ++slot) {
    if (slot % group_size == 0) boundary.first.push_back(static_cast<std::uint32_t>(boundary.edges.size()));
    const TriangleShape shape = space.triangles.shape(slot);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t edge = space.triangles.records[slot].edges[k];
      if (edge == no_index || balance[edge] == 0) continue;
      const auto& ids = space.triangles.records[slot].vertices;
      const bool along = (ids[k] < ids[(k + 1) % 3]) == (balance[edge] > 0);
      const Vec3 &a = shape.vertices[k], &b = shape.vertices[(k + 1) % 3];
      const BoundaryEdge found{along ? a : b, along ? b : a, static_cast<double>(std::abs(balance[edge]))};
      boundary.edges.push_back(found);
      group_length[slot / group_size] += found.times * distance_between(found.from, found.to) * up;
      balance[edge] = 0;
    }
  }
  boundary.first.push_back(static_cast<std::uint32_t>(boundary.edges.size()));
  boundary.lengths.resize(space.bvh.nodes.size());
  for (std::size_t i = boundary.lengths.size(); i-- > 0;) {
    const BvhNode& node = space.bvh.nodes[i];
    const auto index = static_cast<std::uint32_t>(i);
    boundary.lengths[i] =
        node.is_group()
            ? group_length[node.first_group]
            : (boundary.lengths[space.bvh.left(index)] + boundary.lengths[space.bvh.right(index)]) * up;
  }
  return boundary;
}

double winding_drift(const Boundary& boundary, SearchSpace space, const Vec3& centre,
                     double radius) noexcept {
  double sum = 0;
  const auto is_hopeless = [&] { return !(sum * radius < hopeless * four_pi); };
  const auto enter = [&](std::uint32_t index) {
    const double length = boundary.lengths[index];
    if (length == 0 || is_hopeless()) return false;
    const Box& box = space.bvh.nodes[index].box;
    const double gap = std::sqrt(squared_distance_below(centre, box)) * (1 - 0x1p-40) - radius;
    const bool is_far = gap > diagonal_above(box);
    if (is_far) sum += length / gap / gap;
    return !is_far;
  };
  const auto add = [&](std::uint32_t index) {
    const std::uint32_t group = space.bvh.nodes[index].first_group;
    for (std::uint32_t e = boundary.first[group]; e < boundary.first[group + 1]; ++e) {
      const BoundaryEdge& edge = boundary.edges[e];
      sum += edge.times * pull(edge.from, edge.to, centre, radius, most_halvings);
    }
    return !is_hopeless();
  };
  walk(space.bvh, 0, enter, add);
  return is_hopeless() ? infinity : sum * radius / four_pi * up;
}

}  // namespace cdfr
