#include "analysis/first_hit.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/arithmetic.h"
#include "core/vector.h"
#include "geometry/point_triangle.h"
#include "geometry/query_range.h"

namespace cdfr {
namespace {

using Eigen::Vector3d;

struct Hit {
  double way = 0, error = 0;
  std::uint32_t slot = no_index;
};

class Ray {
 public:
  Ray(const FieldData& field, const WallPoint& from, const Vector3d& direction, double rounding) noexcept
      : field_(field), from_(from), p_(to_eigen(from.position)), d_(direction), rounding_(rounding) {}

  /// The first hit nearer than `limit`, or slot no_index. Equal ones go to the lowest triangle.
  Hit first(double limit) noexcept {
    best_.way = limit;
    const auto enter = [&](std::uint32_t node) { return may_meet(field_.bvh.nodes[node].box); };
    const auto group = [&](std::uint32_t node) {
      const std::uint32_t number = field_.bvh.nodes[node].first_group;
      const auto first = static_cast<std::uint32_t>(number * group_size);
      for (std::uint32_t slot = first; slot < first + field_.triangles.lanes(number); ++slot) meet(slot);
      return true;
    };
    walk(field_.bvh, 0, enter, group);
    return best_;
  }

 private:
  /// Slabs (Kay, Kajiya, "Ray tracing complex scenes", 1986) of the box grown by the rounding, which is more
  /// than differences, quotients and products of its coordinates round by.
  bool may_meet(const Box& box) const noexcept {
    double enter = 0, leave = best_.way + rounding_;
    const Vector3d lo = to_eigen(box.lo).array() - rounding_ - p_.array(),
                   hi = to_eigen(box.hi).array() + rounding_ - p_.array();
    for (int i = 0; i < 3; ++i) {
      if (d_[i] == 0) {
        if (lo[i] > 0 || hi[i] < 0) return false;
        continue;
      }
      const double a = lo[i] / d_[i], b = hi[i] / d_[i];
      enter = std::max(enter, std::min(a, b));
      leave = std::min(leave, std::max(a, b));
    }
    return enter <= leave;
  }

  void meet(std::uint32_t slot) noexcept {
    const TriangleShape& shape = field_.triangles.shape(slot);
    if (slot == from_.slot || !may_cross(shape)) return;
    const Hit hit = crossing(slot, shape);
    const auto number = [&](std::uint32_t s) { return field_.triangles.records[s].number; };
    if (!(hit.way >= 0) || hit.way > best_.way) return;
    if (hit.way == best_.way && (best_.slot == no_index || number(slot) > number(best_.slot))) return;
    if (!touches(shape)) best_ = hit;
  }

  /// False if the line certainly passes beside the triangle: an edge has it on one side, another one on the
  /// other. Of determinants of three vectors whose components carry one rounding each, six products round by
  /// less than 8u, so 2^-46 of the product of the largest components covers them.
  bool may_cross(const TriangleShape& shape) const noexcept {
    bool left = false, right = false;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector3d a = to_eigen(shape.vertices[k]) - p_, b = to_eigen(shape.vertices[(k + 1) % 3]) - p_;
      const double side = d_.dot(a.cross(b));
      const double bound = 0x1p-46 * a.lpNorm<Eigen::Infinity>() * b.lpNorm<Eigen::Infinity>();
      left |= side > bound;
      right |= side < -bound;
    }
    return !(left && right);
  }

  /// Where the line meets the triangle's plane, or, if it runs in that plane but for rounding, its border.
  Hit crossing(std::uint32_t slot, const TriangleShape& shape) const noexcept {
    const Vector3d n = to_eigen(rounded(shape.normal));
    Vector3d along;
    for (int k = 0; k < 3; ++k) along[k] = d_.dot(to_eigen(shape.vertices[static_cast<std::size_t>(k)]) - p_);
    const double least = along.minCoeff(), most = along.maxCoeff();
    const Vector3d way = to_eigen(shape.vertices[0]) - p_;
    const double rate = n.dot(d_), t = n.dot(way) / rate;
    // Both dot products and the normal round by less than 8u of the lengths in them.
    const double rounding = rounding_ + 0x1p-49 * (way.norm() + along.lpNorm<Eigen::Infinity>());
    const double error = rounding / std::fabs(rate);
    if (error <= most - least + 2 * rounding) return {std::clamp(t, least, most), error, slot};
    Hit hit = on_border(shape, n.cross(d_), along, rounding);
    hit.slot = slot;
    return hit;
  }

  /// `across` lies in the triangle's plane, at right angles to the line. Behind the point if the line passes
  /// beside the triangle; else the first crossing of a side, or, where rounding leaves none, the extent along
  /// the line.
  Hit on_border(const TriangleShape& shape, const Vector3d& across, const Vector3d& along,
                double rounding) const noexcept {
    const double least = along.minCoeff(), most = along.maxCoeff();
    Vector3d beside;
    for (int k = 0; k < 3; ++k)
      beside[k] = across.dot(to_eigen(shape.vertices[static_cast<std::size_t>(k)]) - p_);
    if (most < 0 || beside.minCoeff() > rounding || beside.maxCoeff() < -rounding) return {-1, 0, no_index};
    Hit hit{std::numeric_limits<double>::infinity(), 0, no_index};
    for (int k = 0; k < 3; ++k) {
      const double a = beside[k], b = beside[(k + 1) % 3], length = along[(k + 1) % 3] - along[k];
      if (std::min(a, b) > rounding || std::max(a, b) < -rounding || std::fabs(a - b) <= rounding) continue;
      const double way = along[k] + length * std::clamp(a / (a - b), 0.0, 1.0);
      if (way < hit.way) hit = {way, rounding * (1 + std::fabs(length / (a - b))), no_index};
    }
    if (hit.error < most - least && hit.way >= 0 && std::isfinite(hit.way)) return hit;
    return {std::max(least, 0.0), most - least + rounding, no_index};
  }

  bool touches(const TriangleShape& shape) const noexcept {
    return square_root(measure(without_dust(from_.position), shape).squared) <= rounding_;
  }

  const FieldData& field_;
  const WallPoint& from_;
  Vector3d p_, d_;
  double rounding_;
  Hit best_;
};

/// Two unit vectors that make a frame with n (Duff et al., "Building an orthonormal basis, revisited", 2017).
struct Frame {
  explicit Frame(const Vector3d& n) noexcept {
    const double sign = std::copysign(1.0, n.z());
    const double a = -1 / (sign + n.z()), b = n.x() * n.y() * a;
    first = {1 + sign * n.x() * n.x() * a, sign * b, -sign * n.x()};
    second = {b, sign + n.y() * n.y() * a, -n.y()};
  }
  Vector3d first, second;
};

Vector3d on_spiral(const Vector3d& axis, int number, const RayOptions& options) noexcept {
  constexpr double golden_angle = 2.3999632297286533, degree = 0.017453292519943295;
  const double share = static_cast<double>(number) / (options.rays - 1);
  const double down = 1 - share * (1 - cosine(options.cone * degree));
  const double across = std::sqrt(std::max(0.0, 1 - down * down));
  const Frame frame(axis);
  const double turn = number * golden_angle;
  return down * axis + across * (cosine(turn) * frame.first + sine(turn) * frame.second);
}

}  // namespace

MeasuredWall shortest_ray(const FieldData& field, const WallPoint& point,
                          const RayOptions& options) noexcept {
  const Vector3d axis = to_eigen(point.direction);
  Hit best{options.largest, 0, no_index};
  Vector3d direction = axis;
  for (int i = 0; i < options.rays; ++i) {
    const Vector3d d = i == 0 ? axis : on_spiral(axis, i, options);
    const Hit hit = Ray(field, point, d, options.rounding).first(best.way);
    if (hit.slot == no_index) continue;
    best = hit;
    direction = d;
  }
  MeasuredWall wall;
  wall.thickness = best.slot == no_index ? std::numeric_limits<double>::quiet_NaN() : best.way;
  if (best.slot == no_index) return wall;
  wall.error = best.error;
  wall.opposite_point = from_eigen(to_eigen(point.position) + best.way * direction);
  wall.opposite = field.triangles.records[best.slot].number;
  wall.opposite_patch = field.triangles.exact[best.slot].patch;
  return wall;
}

}  // namespace cdfr
