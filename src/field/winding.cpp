#include "field/winding.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

#include "core/vector.h"
#include "geometry/angle_sum.h"
#include "geometry/box_distance.h"
#include "geometry/query_range.h"
#include "mesh/crossings.h"
#include "mesh/triangles.h"

namespace cdfr {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
/// Covers the roundings of a sum of a few positive terms.
constexpr double up = 1 + 0x1p-40;
/// Of each partial sum: its rounding.
constexpr double sum_error = 0x1p-52;
/// Boundaries up to this length are summed at once: as quick as an opening of 2.
constexpr std::size_t few_edges = 256;
/// Up to this length they are as quick as an opening that leaves an error of a percent.
constexpr std::size_t short_boundary = 1024;
/// A sum over a boundary that is worse has met an edge. Another direction will not, unless the point itself
/// is there.
constexpr double good_error = 0x1p-24;
constexpr std::uint32_t most_attempts = 8;

/// How far a stored centre may be from the one that the moments were taken about, and half of that again.
double centre_doubt(const Vec3& centre) noexcept { return 0x1p-51 * largest_magnitude(centre); }

/// The centre of the parts' area, or of the box if there is none.
Vec3 centre_of(const Box& box, std::span<const WindingMoments> parts) noexcept {
  const Eigen::Vector3d middle = to_eigen(box.lo) + (to_eigen(box.hi) - to_eigen(box.lo)) / 2;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double total = 0;
  for (const WindingMoments& part : parts) {
    sum += part.total * (to_eigen(part.centre) - middle);
    total += part.total;
  }
  return total > 0 ? from_eigen(middle + sum / total) : from_eigen(middle);
}

/// Moments of all parts about their common centre (Steiner's theorem).
WindingMoments joined(const Box& box, std::span<const WindingMoments> parts) noexcept {
  WindingMoments m;
  m.centre = centre_of(box, parts);
  for (const WindingMoments& part : parts) {
    const Eigen::Vector3d shift = to_eigen(part.centre) - to_eigen(m.centre), area = to_eigen(part.area);
    m.area = from_eigen(to_eigen(m.area) + area);
    for (std::size_t i = 0; i < 3; ++i) {
      const auto a = static_cast<Eigen::Index>(i), b = static_cast<Eigen::Index>((i + 1) % 3);
      m.first[i] += part.first[i] + area[a] * shift[a];
      m.first[3 + i] += part.first[3 + i] + (area[a] * shift[b] + area[b] * shift[a]) / 2;
    }
    m.total = (m.total + part.total) * up;
    m.doubt = (m.doubt + part.doubt) * up;
    m.spread = (m.spread + part.spread + part.total * shift.squaredNorm()) * up;
  }
  const double doubt = centre_doubt(m.centre);
  m.spread += m.total * doubt * doubt;
  const auto reach = [](double c, double lo, double hi) { return std::fmax(c - lo, hi - c); };
  const Eigen::Vector3d far(reach(m.centre.x, box.lo.x, box.hi.x), reach(m.centre.y, box.lo.y, box.hi.y),
                            reach(m.centre.z, box.lo.z, box.hi.z));
  m.radius = up * (far.norm() + doubt);
  return m;
}

WindingMoments of_triangle(const TriangleShape& t) noexcept {
  const Eigen::Vector3d a = to_eigen(t.vertices[0]);
  const Eigen::Vector3d e = to_eigen(t.vertices[1]) - a, f = to_eigen(t.vertices[2]) - a;
  const double area = e.cross(f).norm() / 2;
  const Eigen::Vector3d middle = (e + f) / 3;
  WindingMoments m;
  m.centre = from_eigen(a + middle);
  m.area = from_eigen(to_eigen(rounded(t.normal)) * area);
  // The cross product is off by less than 2^-50 of the product of the edges.
  m.doubt = 0x1p-50 * e.norm() * f.norm();
  m.total = area * up + m.doubt;
  m.spread =
      m.total / 12 * (middle.squaredNorm() + (e - middle).squaredNorm() + (f - middle).squaredNorm()) * up;
  return m;
}

WindingMoments of_group(SearchSpace space, const BvhNode& node) noexcept {
  std::array<WindingMoments, group_size> parts;
  const std::size_t lanes = space.triangles.lanes(node.first_group);
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    parts[lane] =
        of_triangle(space.triangles.shape(static_cast<std::uint32_t>(node.first_group * group_size + lane)));
  }
  return joined(node.box, std::span(parts).first(lanes));
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
  return {value, (rest + 4 * m.doubt + m.total * (0x1p-40 + 8 * centre_doubt(m.centre) / d)) / d / d * up};
}

}  // namespace

WindingTree build_winding_tree(SearchSpace space, std::size_t edge_count, const Scratch* scratch) {
  Large<WindingMoments> nodes(space.bvh.nodes.size(), scratch);
  for (std::size_t i = nodes.size(); i-- > 0;) {  // children come after their parents
    const BvhNode& node = space.bvh.nodes[i];
    const auto index = static_cast<std::uint32_t>(i);
    if (node.is_group()) {
      nodes[i] = of_group(space, node);
    } else {
      nodes[i] = joined(node.box, std::array{nodes[space.bvh.left(index)], nodes[space.bvh.right(index)]});
    }
  }
  return {std::move(nodes), find_boundary(space, edge_count, scratch)};
}

Bounded winding_number(const WindingTree& tree, SearchSpace space, const Vec3& p, double opening) noexcept {
  Bounded sum;
  const auto add = [&](const Bounded& angle) {
    sum.value += angle.value;
    sum.error += angle.error + sum_error * std::fabs(sum.value);
  };
  const auto enter = [&](std::uint32_t index) {
    const WindingMoments& moments = tree.nodes[index];
    const Eigen::Vector3d r = to_eigen(moments.centre) - to_eigen(p);
    const double d = r.norm();
    const bool is_far = d > opening * moments.radius;
    if (is_far) add(angle_of(moments, r, d));
    return !is_far;
  };
  const auto add_group = [&](std::uint32_t index) {
    const std::uint32_t number = space.bvh.nodes[index].first_group;
    const std::uint32_t first = number * std::uint32_t{group_size};
    for (std::uint32_t slot = first; slot < first + space.triangles.lanes(number); ++slot) {
      add(solid_angle(p, space.triangles.shape(slot).vertices));
    }
    return true;
  };
  walk(space.bvh, 0, enter, add_group);
  return {sum.value / four_pi, sum.error / four_pi * up};
}

Bounded winding_by_boundary(const WindingTree& tree, SearchSpace space, const Vec3& p) noexcept {
  Bounded best{0, infinity};
  for (std::uint32_t attempt = 0; attempt < most_attempts; ++attempt) {
    const Vec3 direction = ray_direction(attempt);
    const std::optional<int> crossings = crossings_along(p, direction, space);
    if (!crossings) continue;
    const Vec3 back{-direction.x, -direction.y, -direction.z};
    Bounded sum;
    for (const BoundaryEdge& edge : tree.boundary.edges) {
      const Bounded angle = solid_angle_to_infinity(p, edge.from, edge.to, back);
      sum.value += edge.times * angle.value;
      sum.error += edge.times * angle.error + 2 * sum_error * std::fabs(sum.value);
    }
    const Bounded w{*crossings + sum.value / four_pi, sum.error / four_pi * up};
    if (w.error < best.error) best = w;
    if (best.error < good_error) break;
  }
  return best;
}

namespace {

/// winding_by_boundary in plain double, along the first ray that is not spoilt.
Bounded winding_by_short_boundary(const WindingTree& tree, SearchSpace space, const Vec3& p) noexcept {
  for (std::uint32_t attempt = 0; attempt < most_attempts; ++attempt) {
    const Vec3 direction = ray_direction(attempt);
    const std::optional<int> crossings = crossings_along(p, direction, space);
    if (!crossings) continue;
    const Vec3 back = from_eigen(-to_eigen(direction).normalized());
    AngleSum angles;
    for (const BoundaryEdge& edge : tree.boundary.edges) {
      for (double i = 0; i < edge.times; ++i) angles.add_to_infinity(p, edge.from, edge.to, back);
    }
    const Bounded sum = angles.sum();
    return {*crossings + sum.value / four_pi, sum.error / four_pi * up};
  }
  return {0, infinity};
}

/// w(p), refined until it is farther than `margin` from 1/2 or known to rounding. A short boundary is the
/// quicker way, and if it is shorter than the mesh the surer one; where all of its directions are spoilt, the
/// triangles answer.
Bounded refined(const WindingTree& tree, SearchSpace space, const Vec3& p, double margin) noexcept {
  const auto decided = [margin](const Bounded& w) { return std::fabs(w.value - 0.5) > w.error + margin; };
  const std::size_t edges = tree.boundary.edges.size();
  if (edges <= few_edges) {
    const Bounded w = winding_by_short_boundary(tree, space, p);
    if (decided(w)) return w;
  } else {
    for (const double opening : {2.0, 4.0}) {
      const Bounded w = winding_number(tree, space, p, opening);
      if (decided(w)) return w;
    }
  }
  Bounded best{0, infinity};
  if (edges < space.triangles.size()) {
    best = winding_by_boundary(tree, space, p);
    if (decided(best) || best.error < good_error) return best;
  }
  for (const double opening : {8.0, 16.0, infinity}) {
    const Bounded w = winding_number(tree, space, p, opening);
    if (decided(w)) return w;
    if (w.error < best.error) best = w;
  }
  return best;
}

}  // namespace

Bounded winding_within(const WindingTree& tree, SearchSpace space, const Vec3& p, double error) noexcept {
  Bounded w{0, infinity};
  if (tree.boundary.edges.size() <= short_boundary) w = winding_by_short_boundary(tree, space, p);
  for (double opening = 2; !(w.error <= error) && opening <= 16; opening *= 2)
    w = winding_number(tree, space, p, opening);
  return w;
}

bool winds(const WindingTree& tree, SearchSpace space, const Vec3& p) noexcept {
  return refined(tree, space, p, 0).value > 0.5;
}

Side side_of_ball(const WindingTree& tree, SearchSpace space, const Vec3& centre, double radius) noexcept {
  const double drift = winding_drift(tree.boundary, space, centre, radius);
  if (!std::isfinite(drift)) return Side::undecided;
  const Bounded w = refined(tree, space, centre, drift);
  if (std::fabs(w.value - 0.5) > w.error + drift) return w.value > 0.5 ? Side::inside : Side::outside;
  return Side::undecided;
}

}  // namespace cdfr
