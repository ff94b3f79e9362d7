#include "field/boundary.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "core/vector.h"
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
/// More edges within reach cost more than they are good for.
constexpr std::size_t most_opened = 1024;

/// By edge id: how often triangles run along it from the low vertex to the high one, less the other way.
Large<std::int32_t> balances(const TriangleStore& store, std::size_t edge_count, const Scratch* scratch) {
  Large<std::int32_t> balance(edge_count, scratch);
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

Boundary find_boundary(SearchSpace space, std::size_t edge_count, const Scratch* scratch) {
  Large<std::int32_t> balance = balances(space.triangles, edge_count, scratch);
  Large<BoundaryEdge> edges(scratch);
  Large<std::uint32_t> first(scratch);
  const std::size_t groups = space.triangles.group_count();
  Large<double> group_length(groups, scratch);
  for (std::uint32_t slot = 0; slot < space.triangles.size(); ++slot) {
    if (slot % group_size == 0) first.push_back(static_cast<std::uint32_t>(edges.size()));
    const TriangleShape shape = space.triangles.shape(slot);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t edge = space.triangles.records[slot].edges[k];
      if (edge == no_index || balance[edge] == 0) continue;
      const auto& ids = space.triangles.records[slot].vertices;
      const bool along = (ids[k] < ids[(k + 1) % 3]) == (balance[edge] > 0);
      const Vec3 &a = shape.vertices[k], &b = shape.vertices[(k + 1) % 3];
      const BoundaryEdge found{along ? a : b, along ? b : a, static_cast<double>(std::abs(balance[edge]))};
      edges.push_back(found);
      group_length[slot / group_size] += found.times * distance_between(found.from, found.to) * up;
      balance[edge] = 0;
    }
  }
  first.push_back(static_cast<std::uint32_t>(edges.size()));
  Large<double> lengths(space.bvh.nodes.size(), scratch);
  for (std::size_t i = lengths.size(); i-- > 0;) {
    const BvhNode& node = space.bvh.nodes[i];
    const auto index = static_cast<std::uint32_t>(i);
    lengths[i] = node.is_group() ? group_length[node.first_group]
                                 : (lengths[space.bvh.left(index)] + lengths[space.bvh.right(index)]) * up;
  }
  return {std::move(edges), std::move(first), std::move(lengths)};
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

namespace {

/// Gathers the parts of the boundary around a ball by their pull on it: 4 pi / R of the drift.
class PartsAround {
 public:
  struct Edge {
    double pull;
    std::uint32_t number;
  };

  /// Nodes so far that all of the boundary from there on would pull by `most` at most are taken whole.
  PartsAround(const Boundary& boundary, SearchSpace space, const Vec3& centre, double radius, double most)
      : boundary_(boundary),
        space_(space),
        centre_(centre),
        radius_(radius),
        far_(std::sqrt(boundary.lengths[0] / most)) {
    are_few = walk(
        space.bvh, 0, [&](std::uint32_t node) { return !is_far(node); },
        [&](std::uint32_t node) { return add(space.bvh.nodes[node].first_group); });
    if (!are_few) return;
    std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
      return a.pull != b.pull ? a.pull < b.pull : a.number < b.number;
    });
  }

  bool are_few = false;  ///< not more than most_opened; else nothing else is of use
  double of_nodes = 0;
  std::vector<Edge> edges;  ///< the others, by pull

 private:
  bool is_far(std::uint32_t node) noexcept {
    const double length = boundary_.lengths[node];
    if (length == 0) return true;
    const Box& box = space_.bvh.nodes[node].box;
    const double gap = std::sqrt(squared_distance_below(centre_, box)) * (1 - 0x1p-40) - radius_;
    if (!(gap > far_)) return false;
    of_nodes += length / gap / gap;
    return true;
  }

  bool add(std::uint32_t group) {
    for (std::uint32_t e = boundary_.first[group]; e < boundary_.first[group + 1]; ++e) {
      const BoundaryEdge& edge = boundary_.edges[e];
      const Vec3 &a = edge.from, &b = edge.to;
      const Vec3 middle{a.x + (b.x - a.x) / 2, a.y + (b.y - a.y) / 2, a.z + (b.z - a.z) / 2};
      const double length = distance_between(a, b) * up;
      const double gap = distance_between(centre_, middle) * (1 - 0x1p-40) - length / 2 - radius_;
      edges.push_back({gap > 0 ? edge.times * radius_ * length / gap / gap / gap : infinity, e});
    }
    return edges.size() <= most_opened;
  }

  const Boundary& boundary_;
  SearchSpace space_;
  Vec3 centre_;
  double radius_, far_;
};

/// Gradient of the solid angle at c that hangs on the edge: the integral of r x dl / |r|^3.
Eigen::Vector3d gradient_at(const Vec3& c, const BoundaryEdge& edge) noexcept {
  const Eigen::Vector3d a = to_eigen(edge.from) - to_eigen(c), b = to_eigen(edge.to) - to_eigen(c);
  const double la = a.norm(), lb = b.norm();
  return edge.times * ((la + lb) / (la * lb)) / (la * lb + a.dot(b)) * a.cross(b);
}

}  // namespace

std::optional<BoundaryPart> boundary_around(const Boundary& boundary, SearchSpace space, const Vec3& centre,
                                            double radius, double budget, std::size_t most_near) {
  const double most = budget * four_pi / radius;
  const PartsAround parts(boundary, space, centre, radius, most / 4);
  if (!parts.are_few) return std::nullopt;
  double sum = parts.of_nodes;
  std::size_t kept = 0;
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
  for (; kept < parts.edges.size() && sum + parts.edges[kept].pull <= most; ++kept) {
    sum += parts.edges[kept].pull;
    gradient += gradient_at(centre, boundary.edges[parts.edges[kept].number]);
  }
  BoundaryPart part;
  part.drift = sum * radius / four_pi * up;
  if (parts.edges.size() - kept > most_near || !(sum <= most)) return std::nullopt;
  for (; kept < parts.edges.size(); ++kept) part.near.push_back(parts.edges[kept].number);
  std::sort(part.near.begin(), part.near.end());
  part.gradient = from_eigen(gradient / four_pi);
  return part;
}

}  // namespace cdfr
