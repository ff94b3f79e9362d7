#include "octree/refine.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "geometry/box_distance.h"

namespace cdfr {
namespace {

/// Sample points of a cell: the 27 of the 3 x 3 x 3 lattice that its children's corners are, then the
/// children's centres.
constexpr std::size_t lattice_samples = 27;
constexpr std::size_t sample_count = lattice_samples + 8;

constexpr std::size_t corner_sample(std::size_t child, std::size_t corner) noexcept {
  const std::size_t x = (child & 1) + (corner & 1);
  const std::size_t y = (child >> 1 & 1) + (corner >> 1 & 1);
  const std::size_t z = (child >> 2 & 1) + (corner >> 2 & 1);
  return x + 3 * y + 9 * z;
}
constexpr std::size_t centre_sample(std::size_t child) noexcept { return lattice_samples + child; }

struct Nearest {
  std::uint32_t slot = no_index;
  double squared = HUGE_VAL;
  void operator()(std::uint32_t candidate, double value, double) noexcept {
    if (value < squared) {
      squared = value;
      slot = candidate;
    }
  }
};

class Refinement {
 public:
  Refinement(SearchSpace space, const Lattice& lattice, const OpenCell& parent, const RefineOptions& options)
      : space_(space), lattice_(lattice), parent_(parent), options_(options) {
    size_ = lattice.size(parent.cell.level + 1);
    open_all_ = parent.triangles <= options.open_below;
    for (std::size_t child = 0; child < 8; ++child) {
      children_[child].cell = child_of(parent.cell, static_cast<int>(child));
      if (lattice.meets_brick(children_[child].cell)) wanted_ |= 1U << child;
    }
    place_samples();
    find_dominators();
  }

  std::array<OpenCell, 8> run() {
    for (const Entry& entry : parent_.list) sift(node_of(space_.bvh, entry), entry.lanes(), wanted_);
    for (OpenCell& child : children_) {
      std::sort(child.list.begin(), child.list.end());
    }
    return std::move(children_);
  }

 private:
  void place_samples() {
    const Vec3 lo = lattice_.box(parent_.cell).lo;
    for (std::size_t i = 0; i < lattice_samples; ++i) {
      samples_[i] = {lo.x + static_cast<double>(i % 3) * size_, lo.y + static_cast<double>(i / 3 % 3) * size_,
                     lo.z + static_cast<double>(i / 9) * size_};
    }
    for (std::size_t child = 0; child < 8; ++child) {
      samples_[centre_sample(child)] = lattice_.centre(children_[child].cell);
    }
  }

  /// The surface point closest to a sample, by estimate. The parent's dominators bound the search from the
  /// start.
  Vec3 closest_to(const Vec3& p) const {
    Search<Nearest> search(space_, p, lattice_.reach(), Nearest{});
    std::size_t best = 0;
    for (std::size_t k = 0; k < dominator_count; ++k) {
      const double away = distance_between(p, parent_.dominators[k]);
      if (away * away < search.least()) best = k;
      search.bound(away * away);
    }
    search.accept().squared = search.least();
    search.list(parent_.list, lattice_.edge,
                distance_between(p, lattice_.centre(parent_.cell)) * (1 + 8 * unit_roundoff));
    const std::uint32_t slot = search.accept().slot;
    if (slot == no_index) return parent_.dominators[best];
    return estimate_closest(p, space_.triangles.groups[slot / group_size], slot % group_size);
  }

  void find_dominators() {
    std::array<Vec3, sample_count> closest{};
    std::array<bool, sample_count> known{};
    // The parent's corners and centre are samples too, and their closest points its dominators.
    closest[13] = parent_.dominators[0];
    known[13] = parent_.cell.level > -virtual_levels;
    for (std::size_t corner = 0; corner < 8; ++corner) {
      closest[corner_sample(corner, corner)] = parent_.dominators[1 + corner];
      known[corner_sample(corner, corner)] = parent_.cell.level > -virtual_levels;
    }
    const auto at = [&](std::size_t sample) -> const Vec3& {
      if (!known[sample]) {
        closest[sample] = closest_to(samples_[sample]);
        known[sample] = true;
      }
      return closest[sample];
    };
    for (std::size_t child = 0; child < 8; ++child) {
      if ((wanted_ >> child & 1U) == 0) continue;
      Dominators& dominators = children_[child].dominators;
      dominators.fill(at(centre_sample(child)));
      bands_[child] = band_threshold(lattice_, children_[child].cell.level,
                                     distance_between(samples_[centre_sample(child)], dominators[0]));
      if (options_.lists == Lists::band) continue;
      std::array<Vec3, 8> corners;
      for (std::size_t corner = 0; corner < 8; ++corner) {
        corners[corner] = samples_[corner_sample(child, corner)];
        dominators[1 + corner] = at(corner_sample(child, corner));
      }
      rules_[child] = CornerDominance(lattice_, corners, dominators);
    }
  }

  /// Drops a node from the children that cannot need it; what is left is kept whole, opened or taken apart.
  void sift(std::uint32_t index, std::uint8_t lanes, unsigned children) {
    const BvhNode& node = space_.bvh.nodes[index];
    std::array<double, sample_count> squared;
    for (std::size_t i = 0; i < sample_count; ++i) squared[i] = squared_distance_below(samples_[i], node.box);
    children = surviving(squared, children);
    if (children == 0) return;
    if (node.is_group()) {
      sift_group(index, lanes, children);
    } else if (open_all_ || diagonal_above(node.box) > size_ / 4) {
      sift(space_.bvh.left(index), 0xff, children);
      sift(space_.bvh.right(index), 0xff, children);
    } else {
      for (std::size_t child = 0; child < 8; ++child) {
        if ((children >> child & 1U) != 0) keep(child, index, std::sqrt(squared[centre_sample(child)]), 0xff);
      }
    }
  }

  unsigned surviving(const std::array<double, sample_count>& squared, unsigned children) const {
    for (std::size_t child = 0; child < 8; ++child) {
      if ((children >> child & 1U) == 0) continue;
      bool drop;
      if (options_.lists == Lists::band) {
        drop = squared[centre_sample(child)] > bands_[child];
      } else {
        std::array<double, 8> corners;
        for (std::size_t corner = 0; corner < 8; ++corner)
          corners[corner] = squared[corner_sample(child, corner)];
        drop = rules_[child].drops(corners);
      }
      if (drop) children &= ~(1U << child);
    }
    return children;
  }

  void sift_group(std::uint32_t index, std::uint8_t lanes, unsigned children) {
    const std::uint32_t number = space_.bvh.nodes[index].first_group;
    const TriangleGroup& group = space_.triangles.groups[number];
    lanes &= static_cast<std::uint8_t>(0xffU >> (group_size - space_.triangles.lanes(number)));
    std::array<GroupDistances, sample_count> squared;
    std::array<bool, sample_count> known{};
    const auto at = [&](std::size_t sample) -> const GroupDistances& {
      if (!known[sample]) estimate_squared(samples_[sample], group, squared[sample]);
      known[sample] = true;
      return squared[sample];
    };
    for (std::size_t child = 0; child < 8; ++child) {
      if ((children >> child & 1U) == 0) continue;
      const GroupDistances& centre = at(centre_sample(child));
      std::uint8_t kept = lanes;
      if (options_.lists == Lists::band) {
        for (std::size_t lane = 0; lane < group_size; ++lane) {
          if (centre[lane] > bands_[child]) kept &= static_cast<std::uint8_t>(~(1U << lane));
        }
      } else {
        std::array<const GroupDistances*, 8> corners;
        for (std::size_t corner = 0; corner < 8; ++corner)
          corners[corner] = &at(corner_sample(child, corner));
        kept &= rules_[child].keeps(corners);
      }
      if (kept == 0) continue;
      double least = HUGE_VAL;
      for (std::size_t lane = 0; lane < group_size; ++lane) {
        if ((kept >> lane & 1U) != 0) least = std::min(least, centre[lane]);
      }
      keep(child, index, std::sqrt(least) - estimate_error * lattice_.reach(), kept);
    }
  }

  void keep(std::size_t child, std::uint32_t index, double distance, std::uint8_t lanes) {
    const BvhNode& node = space_.bvh.nodes[index];
    OpenCell& cell = children_[child];
    // One part in 2^50 less covers the root and the division by a power of two's neighbours.
    const double below = std::max(distance * (1 - 0x1p-50) / lattice_.edge, 0.0);
    cell.list.push_back(node.is_group() ? Entry::of_group(node.first_group, below, lanes)
                                        : Entry::of_node(index, below));
    cell.triangles +=
        node.is_group() ? static_cast<std::uint64_t>(std::popcount(lanes)) : triangles_below(node);
  }

  std::uint64_t triangles_below(const BvhNode& node) const noexcept {
    const std::uint64_t end =
        std::min<std::uint64_t>(std::uint64_t{node.end_group} * group_size, space_.triangles.size());
    return end - std::uint64_t{node.first_group} * group_size;
  }

  SearchSpace space_;
  const Lattice& lattice_;
  const OpenCell& parent_;
  const RefineOptions& options_;
  double size_ = 0;
  bool open_all_ = false;
  unsigned wanted_ = 0;
  std::array<Vec3, sample_count> samples_{};
  std::array<OpenCell, 8> children_;
  std::array<CornerDominance, 8> rules_;
  std::array<double, 8> bands_{};
};

}  // namespace

OpenCell root_cell(SearchSpace space) {
  OpenCell root;
  const bool single = space.bvh.nodes[0].is_group();
  root.list.push_back(single ? Entry::of_group(0, 0, 0xff) : Entry::of_node(0, 0));
  root.triangles = space.triangles.size();
  root.dominators.fill(space.triangles.groups[0].vertex(0, 0));
  return root;
}

std::array<OpenCell, 8> refine(SearchSpace space, const Lattice& lattice, const OpenCell& parent,
                               const RefineOptions& options) {
  return Refinement(space, lattice, parent, options).run();
}

}  // namespace cdfr
