#include "analysis/nearest_point.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>

#include "geometry/double_double.h"

namespace cdfr {
namespace {

double along(const Vec3& p, int axis) noexcept { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; }

void halve(std::span<const Vec3> points, std::span<std::uint32_t> order, int axis) {
  if (order.size() < 2) return;
  const std::size_t middle = order.size() / 2;
  std::nth_element(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(middle), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) {
                     const double x = along(points[a], axis), y = along(points[b], axis);
                     return x != y ? x < y : a < b;
                   });
  halve(points, order.first(middle), (axis + 1) % 3);
  halve(points, order.subspan(middle + 1), (axis + 1) % 3);
}

}  // namespace

PointTree::PointTree(std::span<const Vec3> points) : points_(points), order_(points.size()) {
  std::iota(order_.begin(), order_.end(), 0U);
  halve(points_, order_, 0);
}

std::uint32_t PointTree::nearest(const Vec3& x) const noexcept {
  Best best{std::numeric_limits<double>::infinity(), order_.front()};
  look(0, order_.size(), 0, x, best);
  return best.number;
}

void PointTree::look(std::size_t first, std::size_t end, int axis, const Vec3& x, Best& best) const noexcept {
  if (first >= end) return;
  const std::size_t middle = first + (end - first) / 2;
  const std::uint32_t number = order_[middle];
  const Vec3& p = points_[number];
  const double dx = p.x - x.x, dy = p.y - x.y, dz = p.z - x.z;
  const double squared = dx * dx + dy * dy + dz * dz;
  if (squared < best.squared || (squared == best.squared && number < best.number)) best = {squared, number};
  const double beyond = along(x, axis) - along(p, axis);
  const int next = (axis + 1) % 3;
  const auto near = [&] {
    beyond < 0 ? look(first, middle, next, x, best) : look(middle + 1, end, next, x, best);
  };
  const auto far = [&] {
    beyond < 0 ? look(middle + 1, end, next, x, best) : look(first, middle, next, x, best);
  };
  near();
  // A square rounds down by less than u: none that is as near is passed over.
  if (beyond * beyond * (1 - 4 * unit_roundoff) <= best.squared) far();
}

}  // namespace cdfr
