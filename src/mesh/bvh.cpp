#include "mesh/bvh.h"

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

#include "geometry/box_distance.h"

namespace cdfr {
namespace {

using Array3 = std::array<double, 3>;

constexpr std::size_t bin_count = 32;
constexpr std::size_t parallel_grain = 4096;
/// Below this depth nodes are halved: with 2^29 groups no path is longer than 40 + 29, which bounds every
/// stack.
constexpr int halving_depth = 40;
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr Box empty_box{{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};

double half_area(const Box& b) noexcept {
  const double x = b.hi.x - b.lo.x, y = b.hi.y - b.lo.y, z = b.hi.z - b.lo.z;
  return x < 0 ? 0 : x * y + y * z + z * x;
}

/// A triangle's box; its middle sorts it.
struct Item {
  Box box;
  Array3 middle;
  std::uint32_t number;
};

struct Cut {
  int axis = 0;
  std::size_t left = 0;  ///< items to the left, a multiple of eight
};

std::size_t whole_groups(std::size_t items) noexcept { return (items + group_size - 1) / group_size; }

class Builder {
 public:
  Builder(std::span<Item> items, std::span<BvhNode> nodes) : items_(items), nodes_(nodes) {}

  void build(std::size_t first, std::size_t end, std::size_t node, int depth) {
    BvhNode& n = nodes_[node];
    n.first_group = static_cast<std::uint32_t>(first / group_size);
    n.end_group = n.first_group + static_cast<std::uint32_t>(whole_groups(end - first));
    n.box = empty_box;
    for (const Item& item : items_.subspan(first, end - first)) n.box = united(n.box, item.box);
    if (n.is_group()) {
      std::sort(items_.begin() + first, items_.begin() + end,
                [](const Item& a, const Item& b) { return a.number < b.number; });
      return;
    }
    const Cut cut = best_cut(first, end, depth);
    partition(first, end, cut);
    const std::size_t middle = first + cut.left;
    const std::size_t right = node + 2 * (cut.left / group_size);
    if (end - first > parallel_grain) {
      tbb::parallel_invoke([&] { build(first, middle, node + 1, depth + 1); },
                           [&] { build(middle, end, right, depth + 1); });
    } else {
      build(first, middle, node + 1, depth + 1);
      build(middle, end, right, depth + 1);
    }
  }

 private:
  /// Counts and boxes by bin along one axis, then the boundary with the least expected cost, moved to a whole
  /// group.
  void try_axis(std::size_t first, std::size_t end, int axis, double lo, double hi, Cut& best,
                double& best_cost) const {
    struct Bin {
      Box box = empty_box;
      std::size_t count = 0;
    };
    std::array<Bin, bin_count> bins;
    const double width = (hi - lo) / bin_count;
    for (const Item& item : items_.subspan(first, end - first)) {
      const double b = (item.middle[axis] - lo) / width;
      Bin& bin = bins[std::min(static_cast<std::size_t>(std::max(b, 0.0)), bin_count - 1)];
      bin.box = united(bin.box, item.box);
      ++bin.count;
    }
    std::array<double, bin_count> right_cost{};
    Box box = empty_box;
    std::size_t count = 0;
    for (std::size_t b = bin_count - 1; b > 0; --b) {
      box = united(box, bins[b].box);
      count += bins[b].count;
      right_cost[b] = half_area(box) * static_cast<double>(whole_groups(count));
    }
    box = empty_box;
    count = 0;
    for (std::size_t b = 0; b + 1 < bin_count; ++b) {
      box = united(box, bins[b].box);
      count += bins[b].count;
      const double cost = half_area(box) * static_cast<double>(whole_groups(count)) + right_cost[b + 1];
      const std::size_t left = (count + group_size / 2) / group_size * group_size;
      if (cost < best_cost && left > 0 && left < end - first) {
        best_cost = cost;
        best = {axis, left};
      }
    }
  }

  Cut best_cut(std::size_t first, std::size_t end, int depth) const {
    Array3 lo{infinity, infinity, infinity}, hi{-infinity, -infinity, -infinity};
    for (const Item& item : items_.subspan(first, end - first)) {
      for (int axis = 0; axis < 3; ++axis) {
        lo[axis] = std::min(lo[axis], item.middle[axis]);
        hi[axis] = std::max(hi[axis], item.middle[axis]);
      }
    }
    int longest = 0;
    for (int axis = 1; axis < 3; ++axis) {
      if (hi[axis] - lo[axis] > hi[longest] - lo[longest]) longest = axis;
    }
    // Where no bin boundary serves (all middles equal, or fewer than two groups apart) the median does.
    Cut cut{longest, whole_groups((end - first) / 2) * group_size};
    if (depth >= halving_depth) return cut;
    double cost = infinity;
    for (int axis = 0; axis < 3; ++axis) {
      if (hi[axis] > lo[axis]) try_axis(first, end, axis, lo[axis], hi[axis], cut, cost);
    }
    return cut;
  }

  void partition(std::size_t first, std::size_t end, Cut cut) {
    const auto before = [axis = cut.axis](const Item& a, const Item& b) {
      return a.middle[axis] != b.middle[axis] ? a.middle[axis] < b.middle[axis] : a.number < b.number;
    };
    std::nth_element(items_.begin() + first, items_.begin() + first + cut.left, items_.begin() + end, before);
  }

  std::span<Item> items_;
  std::span<BvhNode> nodes_;
};

std::vector<Item> items_of(MeshView mesh) {
  std::vector<Item> items(mesh.triangles.size());
  for (std::size_t i = 0; i < items.size(); ++i) {
    Box box = empty_box;
    for (const std::uint32_t v : mesh.triangles[i]) box = united(box, {mesh.vertices[v], mesh.vertices[v]});
    items[i] = {box,
                {box.lo.x / 2 + box.hi.x / 2, box.lo.y / 2 + box.hi.y / 2, box.lo.z / 2 + box.hi.z / 2},
                static_cast<std::uint32_t>(i)};
  }
  return items;
}

}  // namespace

BvhAndOrder build_bvh(MeshView mesh) {
  std::vector<Item> items = items_of(mesh);
  BvhAndOrder result;
  result.bvh.nodes.resize(2 * whole_groups(items.size()) - 1);
  Builder(items, result.bvh.nodes).build(0, items.size(), 0, 0);
  result.order.reserve(items.size());
  for (const Item& item : items) result.order.push_back(item.number);
  return result;
}

}  // namespace cdfr
