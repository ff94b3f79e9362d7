#include "mesh/bvh.h"

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "core/parallel.h"
#include "geometry/box_distance.h"
#include "mesh/counts.h"

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

/// Two registers of four, for costs only: what nodes keep is exact.
struct RoundBox {
  std::array<float, 4> lo{HUGE_VALF, HUGE_VALF, HUGE_VALF, HUGE_VALF};
  std::array<float, 4> hi{-HUGE_VALF, -HUGE_VALF, -HUGE_VALF, -HUGE_VALF};

  void add(const RoundBox& other) noexcept {
    for (std::size_t i = 0; i < 4; ++i) lo[i] = other.lo[i] < lo[i] ? other.lo[i] : lo[i];
    for (std::size_t i = 0; i < 4; ++i) hi[i] = other.hi[i] > hi[i] ? other.hi[i] : hi[i];
  }
  float half_area() const noexcept {
    const float x = hi[0] - lo[0], y = hi[1] - lo[1], z = hi[2] - lo[2];
    return x < 0 ? 0 : x * y + y * z + z * x;
  }
};

/// A triangle's middle sorts it.
struct Item {
  RoundBox box;  ///< as a share of the mesh's: in single precision, whatever the mesh's unit and place
  Array3 middle;
  std::uint32_t number;
};

struct Cut {
  int axis = 0;
  std::size_t left = 0;  ///< items to the left, a multiple of eight
};

std::size_t whole_groups(std::size_t items) noexcept { return (items + group_size - 1) / group_size; }

/// Bins of equal width along one axis.
struct Binning {
  double lo = 0, width = 0;

  /// Never less for a larger middle.
  std::size_t of(double middle) const noexcept {
    const double b = (middle - lo) / width;
    return std::min(static_cast<std::size_t>(std::max(b, 0.0)), bin_count - 1);
  }
};

class Builder {
 public:
  Builder(MeshView mesh, std::span<Item> items, std::span<BvhNode> nodes)
      : mesh_(mesh), items_(items), nodes_(nodes) {}

  void build(std::size_t first, std::size_t end, std::size_t node, int depth) {
    BvhNode& n = nodes_[node];
    n.first_group = static_cast<std::uint32_t>(first / group_size);
    n.end_group = n.first_group + static_cast<std::uint32_t>(whole_groups(end - first));
    if (n.is_group()) return finish_group(n, items_.subspan(first, end - first));
    const Cut cut = halved_or_best(first, end, depth);
    const std::size_t middle = first + cut.left;
    const std::size_t right = node + 2 * (cut.left / group_size);
    if (end - first > parallel_grain) {
      tbb::parallel_invoke([&] { build(first, middle, node + 1, depth + 1); },
                           [&] { build(middle, end, right, depth + 1); });
    } else {
      build(first, middle, node + 1, depth + 1);
      build(middle, end, right, depth + 1);
    }
    n.box = united(nodes_[node + 1].box, nodes_[right].box);
  }

 private:
  void finish_group(BvhNode& node, std::span<Item> items) const {
    std::sort(items.begin(), items.end(), [](const Item& a, const Item& b) { return a.number < b.number; });
    node.box = empty_box;
    for (const Item& item : items) {
      for (const std::uint32_t v : mesh_.triangles[item.number])
        node.box = united(node.box, {mesh_.vertices[v], mesh_.vertices[v]});
    }
  }

  struct Bin {
    RoundBox box;
    std::size_t count = 0;
  };
  using Bins = std::array<std::array<Bin, bin_count>, 3>;

  /// The boundary between bins with the least expected cost, moved to a whole group.
  static void try_axis(const Bins& all, int axis, std::size_t items, Cut& best, float& best_cost) {
    const auto& bins = all[static_cast<std::size_t>(axis)];
    std::array<float, bin_count> right_cost{};
    RoundBox box;
    std::size_t count = 0;
    for (std::size_t b = bin_count - 1; b > 0; --b) {
      box.add(bins[b].box);
      count += bins[b].count;
      right_cost[b] = box.half_area() * static_cast<float>(whole_groups(count));
    }
    box = {};
    count = 0;
    for (std::size_t b = 0; b + 1 < bin_count; ++b) {
      box.add(bins[b].box);
      count += bins[b].count;
      const float cost = box.half_area() * static_cast<float>(whole_groups(count)) + right_cost[b + 1];
      const std::size_t left = (count + group_size / 2) / group_size * group_size;
      if (cost < best_cost && left > 0 && left < items) {
        best_cost = cost;
        best = {axis, left};
      }
    }
  }

  std::array<Binning, 3> binnings(std::span<const Item> items) const {
    Array3 lo{infinity, infinity, infinity}, hi{-infinity, -infinity, -infinity};
    for (const Item& item : items) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        lo[axis] = std::min(lo[axis], item.middle[axis]);
        hi[axis] = std::max(hi[axis], item.middle[axis]);
      }
    }
    std::array<Binning, 3> result;
    for (std::size_t axis = 0; axis < 3; ++axis) result[axis] = {lo[axis], (hi[axis] - lo[axis]) / bin_count};
    return result;
  }

  /// Puts the items of the cut's left side first.
  Cut halved_or_best(std::size_t first, std::size_t end, int depth) {
    const auto items = items_.subspan(first, end - first);
    const auto by_axis = binnings(items);
    int longest = 0;
    for (int axis = 1; axis < 3; ++axis) {
      if (by_axis[axis].width > by_axis[longest].width) longest = axis;
    }
    // Where no bin boundary serves (all middles equal, or fewer than two groups apart) the median does.
    Cut cut{longest, whole_groups(items.size() / 2) * group_size};
    if (depth < halving_depth && by_axis[longest].width > 0) {
      Bins bins;
      for (const Item& item : items) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
          if (!(by_axis[axis].width > 0)) continue;
          Bin& bin = bins[axis][by_axis[axis].of(item.middle[axis])];
          bin.box.add(item.box);
          ++bin.count;
        }
      }
      float cost = HUGE_VALF;
      for (int axis = 0; axis < 3; ++axis) {
        if (by_axis[axis].width > 0) try_axis(bins, axis, items.size(), cut, cost);
      }
    }
    partition(items, cut, by_axis[cut.axis]);
    return cut;
  }

  /// Middles in the cut's own bin are told apart; those of other bins are on their side at once.
  static void partition(std::span<Item> items, Cut cut, const Binning& binning) {
    const auto before = [axis = cut.axis](const Item& a, const Item& b) {
      return a.middle[axis] != b.middle[axis] ? a.middle[axis] < b.middle[axis] : a.number < b.number;
    };
    auto first = items.begin(), end = items.end();
    if (binning.width > 0) {
      std::array<std::size_t, bin_count> counts{};
      for (const Item& item : items) ++counts[binning.of(item.middle[cut.axis])];
      std::size_t own = 0, passed = 0;
      while (passed + counts[own] <= cut.left) passed += counts[own++];
      const auto bin_of = [&](const Item& item) { return binning.of(item.middle[cut.axis]); };
      first = std::partition(first, end, [&](const Item& item) { return bin_of(item) < own; });
      end = std::partition(first, end, [&](const Item& item) { return bin_of(item) == own; });
    }
    std::nth_element(first, items.begin() + static_cast<std::ptrdiff_t>(cut.left), end, before);
  }

  MeshView mesh_;
  std::span<Item> items_;
  std::span<BvhNode> nodes_;
};

/// The share of a box that a coordinate is at, along one axis.
struct Share {
  double lo = 0, scale = 0;
  float of(double x) const noexcept { return static_cast<float>((x - lo) * scale); }
};

Item item_of(const std::array<Vec3, 3>& corners, const std::array<Share, 3>& shares, std::uint32_t number) {
  Item item;
  item.number = number;
  const double xyz[3][3] = {{corners[0].x, corners[1].x, corners[2].x},
                            {corners[0].y, corners[1].y, corners[2].y},
                            {corners[0].z, corners[1].z, corners[2].z}};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto& c = xyz[axis];
    const double lo = std::min(std::min(c[0], c[1]), c[2]), hi = std::max(std::max(c[0], c[1]), c[2]);
    item.box.lo[axis] = shares[axis].of(lo);
    item.box.hi[axis] = shares[axis].of(hi);
    item.middle[axis] = lo / 2 + hi / 2;
  }
  return item;
}

Large<Item> items_of(MeshView mesh, const Scratch* scratch) {
  const Box box = box_of(mesh);
  const double longest = longest_side(box);
  const double scale = longest > 0 ? 1 / longest : 0;
  const std::array<Share, 3> shares{Share{box.lo.x, scale}, Share{box.lo.y, scale}, Share{box.lo.z, scale}};
  Large<Item> items(mesh.triangles.size(), scratch);
  for_chunks(items.size(), parallel_grain, [&](std::size_t first, std::size_t end) {
    for (std::size_t i = first; i < end; ++i) {
      const Triangle& t = mesh.triangles[i];
      items[i] = item_of({mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]}, shares,
                         static_cast<std::uint32_t>(i));
    }
  });
  return items;
}

}  // namespace

BvhAndOrder build_bvh(MeshView mesh, const Scratch* scratch) {
  Large<Item> items = items_of(mesh, scratch);
  Large<BvhNode> nodes(2 * whole_groups(items.size()) - 1, scratch);
  Builder(mesh, items, nodes).build(0, items.size(), 0, 0);
  BvhAndOrder result{{std::move(nodes)}, Large<std::uint32_t>(scratch)};
  result.order.reserve(items.size());
  for (const Item& item : items) result.order.push_back(item.number);
  return result;
}

}  // namespace cdfr
