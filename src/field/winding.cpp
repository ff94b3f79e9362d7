#include "field/winding.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "core/vector.h"
#include "geometry/box_distance.h"
#include "mesh/triangles.h"

namespace cdfr {
namespace {

constexpr double four_pi = 12.566370614359172;
constexpr double infinity = std::numeric_limits<double>::infinity();
/// Covers the roundings of a sum of a few positive terms.
constexpr double up = 1 + 0x1p-40;
/// Openings tried before single triangles: each costs a few times the one before.
constexpr double openings[] = {2, 4, 8, 16, infinity};

/// By edge id: how often triangles run along it from the low vertex to the high one, less the other way.
std::vector<std::int32_t> balances(const TriangleStore& store, std::size_t edge_count) {
  std::vector<std::int32_t> balance(edge_count);
  for (const TriangleRecord& record : store.records) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t edge = record.edges[k];
      if (edge == no_index) continue;
      balance[edge] += record.vertices[k] < record.vertices[(k + 1) % 3] ? 1 : -1;
    }
  }
  return balance;
}

/// Moments of parts, first about the origin of their own, joined about the centre of all.
class Gathering {
 public:
  explicit Gathering(const Box& box) noexcept : box_(box) {
    m_.centre = {box.lo.x + (box.hi.x - box.lo.x) / 2, box.lo.y + (box.hi.y - box.lo.y) / 2,
                 box.lo.z + (box.hi.z - box.lo.z) / 2};
  }

  void centre_on(const WindingMoments* parts, std::size_t count) noexcept {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double total = 0;
    for (std::size_t i = 0; i < count; ++i) {
      sum += parts[i].total * (to_eigen(parts[i].centre) - to_eigen(m_.centre));
      total += parts[i].total;
    }
    if (total > 0) m_.centre = from_eigen(to_eigen(m_.centre) + sum / total);
  }

  void add(const WindingMoments& part) noexcept {
    const Eigen::Vector3d shift = to_eigen(part.centre) - to_eigen(m_.centre);
    const Eigen::Vector3d area = to_eigen(part.area);
    m_.area = from_eigen(to_eigen(m_.area) + area);
    for (std::size_t i = 0; i < 3; ++i) {
      const auto a = static_cast<Eigen::Index>(i), b = static_cast<Eigen::Index>((i + 1) % 3);
      m_.first[i] += part.first[i] + area[a] * shift[a];
      m_.first[3 + i] += part.first[3 + i] + (area[a] * shift[b] + area[b] * shift[a]) / 2;
    }
    m_.total = (m_.total + part.total) * up;
    m_.spread = (m_.spread + part.spread + part.total * shift.squaredNorm()) * up;
    m_.boundary = (m_.boundary + part.boundary) * up;
  }

  WindingMoments result() noexcept {
    const auto reach = [](double c, double lo, double hi) { return std::fmax(c - lo, hi - c); };
    const Vec3 far{reach(m_.centre.x, box_.lo.x, box_.hi.x), reach(m_.centre.y, box_.lo.y, box_.hi.y),
                   reach(m_.centre.z, box_.lo.z, box_.hi.z)};
    m_.radius = to_eigen(far).norm() * up;
    return m_;
  }

 private:
  Box box_;
  WindingMoments m_;
};

WindingMoments of_triangle(const TriangleShape& t) noexcept {
  const Eigen::Vector3d a = to_eigen(t.vertices[0]);
  const Eigen::Vector3d e = to_eigen(t.vertices[1]) - a, f = to_eigen(t.vertices[2]) - a;
  const double area = e.cross(f).norm() / 2;
  const Eigen::Vector3d middle = (e + f) / 3;
  WindingMoments m;
  m.centre = from_eigen(a + middle);
  m.area = from_eigen(to_eigen(rounded(t.normal)) * area);
  // The cross product is off by less than 2^-50 of the product of the edges.
  m.total = area * up + 0x1p-50 * e.norm() * f.norm();
  m.spread =
      m.total / 12 * (middle.squaredNorm() + (e - middle).squaredNorm() + (f - middle).squaredNorm()) * up;
  return m;
}

WindingMoments of_group(SearchSpace space, const BvhNode& node, std::vector<std::int32_t>& balance) {
  std::array<WindingMoments, group_size> parts;
  const std::size_t lanes = space.triangles.lanes(node.first_group);
  Gathering sum(node.box);
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    const auto slot = static_cast<std::uint32_t>(node.first_group * group_size + lane);
    const TriangleShape shape = space.triangles.shape(slot);
    const TriangleRecord& record = space.triangles.records[slot];
    parts[lane] = of_triangle(shape);
    for (std::size_t k = 0; k < 3; ++k) {
      if (record.edges[k] == no_index) continue;
      std::int32_t& times = balance[record.edges[k]];
      parts[lane].boundary +=
          std::abs(times) * distance_between(shape.vertices[k], shape.vertices[(k + 1) % 3]) * up;
      times = 0;
    }
  }
  sum.centre_on(parts.data(), lanes);
  for (std::size_t lane = 0; lane < lanes; ++lane) sum.add(parts[lane]);
  return sum.result();
}

/// The node's angle. Precondition: d > radius. Divided step by step, so that nothing overflows.
Bounded angle_of(const WindingMoments& m, const Eigen::Vector3d& r, double d) noexcept {
  const Eigen::Vector3d n = r / d;
  const double trace = m.first[0] + m.first[1] + m.first[2];
  const double bent =
      m.first[0] * n.x() * n.x() + m.first[1] * n.y() * n.y() + m.first[2] * n.z() * n.z() +
      2 * (m.first[3] * n.x() * n.y() + m.first[4] * n.y() * n.z() + m.first[5] * n.z() * n.x());
  const double q = m.radius / d;
  const double value = (to_eigen(m.area).dot(n) + (trace - 3 * bent) / d) / d / d;
  const double rest = m.spread / d / d * ((3 - 2 * q) / ((1 - q) * (1 - q)));
  return {value, (rest + 0x1p-40 * m.total) / d / d * up};
}

}  // namespace

WindingTree build_winding_tree(SearchSpace space, std::size_t edge_count) {
  std::vector<std::int32_t> balance = balances(space.triangles, edge_count);
  WindingTree tree(space.bvh.nodes.size());
  // Children come after their parents, and groups in the order of their slots are met backwards: an edge's
  // length goes to its last triangle.
  for (std::size_t i = tree.size(); i-- > 0;) {
    const BvhNode& node = space.bvh.nodes[i];
    if (node.is_group()) {
      tree[i] = of_group(space, node, balance);
      continue;
    }
    const auto index = static_cast<std::uint32_t>(i);
    const WindingMoments parts[2] = {tree[space.bvh.left(index)], tree[space.bvh.right(index)]};
    Gathering sum(node.box);
    sum.centre_on(parts, 2);
    for (const WindingMoments& part : parts) sum.add(part);
    tree[i] = sum.result();
  }
  return tree;
}

Bounded winding_number(const WindingTree& tree, SearchSpace space, const Vec3& p, double opening) noexcept {
  Bounded sum;
  std::array<std::uint32_t, bvh_depth_limit> stack;
  std::size_t size = 0;
  stack[size++] = 0;
  while (size > 0) {
    const std::uint32_t index = stack[--size];
    const WindingMoments& moments = tree[index];
    const BvhNode& node = space.bvh.nodes[index];
    const Eigen::Vector3d r = to_eigen(moments.centre) - to_eigen(p);
    const double d = r.norm();
    if (d > opening * moments.radius) {
      const Bounded angle = angle_of(moments, r, d);
      sum.value += angle.value;
      sum.error += angle.error;
    } else if (!node.is_group()) {
      stack[size++] = space.bvh.right(index);
      stack[size++] = space.bvh.left(index);
    } else {
      const TriangleGroup& group = space.triangles.groups[node.first_group];
      for (std::size_t lane = 0; lane < space.triangles.lanes(node.first_group); ++lane) {
        const Bounded angle =
            solid_angle(p, {group.vertex(0, lane), group.vertex(1, lane), group.vertex(2, lane)});
        sum.value += angle.value;
        sum.error += angle.error + 0x1p-50;
      }
    }
  }
  return {sum.value / four_pi, sum.error / four_pi * up};
}

bool winds(const WindingTree& tree, SearchSpace space, const Vec3& p) noexcept {
  Bounded w;
  for (const double opening : openings) {
    w = winding_number(tree, space, p, opening);
    if (std::fabs(w.value - 0.5) > w.error) break;
  }
  return w.value > 0.5;
}

Side side_of_ball(const WindingTree& tree, SearchSpace space, const Vec3& centre, double radius) noexcept {
  double drift = 0;
  std::array<std::uint32_t, bvh_depth_limit> stack;
  std::size_t size = 0;
  stack[size++] = 0;
  while (size > 0) {
    const std::uint32_t index = stack[--size];
    const BvhNode& node = space.bvh.nodes[index];
    const double length = tree[index].boundary;
    if (length == 0) continue;
    const double gap = std::sqrt(squared_distance_below(centre, node.box)) * (1 - 0x1p-50) - radius;
    if (!node.is_group() && !(gap > 2 * tree[index].radius)) {
      stack[size++] = space.bvh.right(index);
      stack[size++] = space.bvh.left(index);
      continue;
    }
    if (!(gap > 0)) return Side::undecided;
    drift += radius * length / (four_pi * gap * gap) * up;
    if (!(drift < 8)) return Side::undecided;
  }
  for (const double opening : openings) {
    const Bounded w = winding_number(tree, space, centre, opening);
    if (std::fabs(w.value - 0.5) > w.error + drift) return w.value > 0.5 ? Side::inside : Side::outside;
    if (w.error < drift / 8) break;
  }
  return Side::undecided;
}

}  // namespace cdfr
