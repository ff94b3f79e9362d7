/// Looks for the triangles that may be closest to a point, in a leaf's list or from a BVH node down, by
/// estimates.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>

#include "geometry/box_distance.h"
#include "geometry/triangle_group.h"
#include "mesh/bvh.h"
#include "mesh/triangles.h"
#include "octree/blocks.h"

namespace cdfr {

/// The groups that an entry stands for: first .. end - 1.
struct GroupRange {
  std::uint32_t first, end;
};
inline GroupRange groups_of(const Bvh& bvh, const Entry& entry) noexcept {
  if (entry.is_group()) return {entry.number(), entry.number() + 1};
  const BvhNode& node = bvh.nodes[entry.number()];
  return {node.first_group, node.end_group};
}

/// `Accept` is called with (slot, estimated squared distance) for each triangle that is not yet known to
/// lose: at the end, those accepted with a value of at most `reject()` include every triangle whose distance
/// is least, even by the last bit of the kernel. With eps = estimate_error * R a triangle whose estimate
/// exceeds the least one by more than 2 eps loses.
template <class Accept>
class Search {
 public:
  /// `reach` is R: a bound on the distance from p to every vertex.
  Search(SearchSpace space, const Vec3& p, double reach, Accept accept) noexcept
      : space_(space), p_(p), slack_(2 * estimate_error * reach), accept_(std::move(accept)) {}

  /// A squared distance that is known to be reached on the surface, to within estimate_error * R of the
  /// distance.
  void bound(double squared) noexcept {
    if (squared < least_) lower(squared);
  }
  double least() const noexcept { return least_; }
  double reject() const noexcept { return reject_; }
  Accept& accept() noexcept { return accept_; }

  /// A leaf's list. `unit` turns entry distances into lengths; `from_centre` is |p - centre|, rounded up.
  void list(std::span<const Entry> entries, double unit, double from_centre) noexcept {
    for (const Entry& entry : entries) {
      if (entry.distance() * unit - from_centre > radius_) break;
      if (entry.is_group()) {
        group(entry.number(), entry.lanes());
      } else {
        descend(entry.number());
      }
    }
  }

  /// Everything below a BVH node, nearer child first.
  void descend(std::uint32_t root) noexcept {
    std::array<Pending, bvh_depth_limit> stack;
    std::size_t size = 0;
    Pending next = pending(root);
    for (;;) {
      if (next.squared <= reject_) {
        const BvhNode& node = space_.bvh.nodes[next.node];
        if (!node.is_group()) {
          Pending near = pending(space_.bvh.left(next.node));
          Pending far = pending(space_.bvh.right(next.node));
          if (far.squared < near.squared) std::swap(near, far);
          stack[size++] = far;
          next = near;
          continue;
        }
        group(node.first_group, 0xff);
      }
      if (size == 0) return;
      next = stack[--size];
    }
  }

  /// One group's triangles, of the given lanes.
  void group(std::uint32_t number, std::uint8_t lanes) noexcept {
    GroupDistances squared;
    estimate_squared(p_, space_.triangles.group(number), squared);
    const std::size_t used = space_.triangles.lanes(number);
    for (std::size_t lane = 0; lane < used; ++lane) {
      if ((lanes >> lane & 1U) == 0 || squared[lane] > reject_) continue;
      if (squared[lane] < least_) lower(squared[lane]);
      accept_(static_cast<std::uint32_t>(number * group_size + lane), squared[lane], reject_);
    }
  }

 private:
  struct Pending {
    std::uint32_t node;
    double squared;
  };

  Pending pending(std::uint32_t node) const noexcept {
    return {node, squared_distance_below(p_, space_.bvh.nodes[node].box)};
  }

  void lower(double squared) noexcept {
    least_ = squared;
    radius_ = std::sqrt(squared) * (1 + 4 * unit_roundoff) + slack_;
    reject_ = radius_ * radius_ * (1 + 4 * unit_roundoff);
  }

  SearchSpace space_;
  Vec3 p_;
  double slack_;
  Accept accept_;
  double least_ = std::numeric_limits<double>::infinity();
  double radius_ = std::numeric_limits<double>::infinity();
  double reject_ = std::numeric_limits<double>::infinity();
};

}  // namespace cdfr
