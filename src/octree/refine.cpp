#include "octree/refine.h"

#include <algorithm>
#include <cmath>

#include "geometry/box_distance.h"

namespace cdfr {
namespace {

constexpr std::size_t parents_centre = 13;

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
  Refinement(SearchSpace space, const Lattice& lattice, const OpenCell& parent, const RefineOptions& options,
             RefineScratch& scratch)
      : space_(space), lattice_(lattice), parent_(parent), options_(options), scratch_(scratch) {
    size_ = lattice.size(parent.cell.level + 1);
    samples_ = Samples(lattice.box(parent.cell).lo, size_);
    open_all_ = parent.triangles <= options.open_below;
    for (std::size_t child = 0; child < 8; ++child) {
      children_[child].cell = child_of(parent.cell, static_cast<int>(child));
      if (lattice.meets_brick(children_[child].cell)) wanted_ |= 1U << child;
      scratch.lists[child].clear();
    }
  }

  std::array<OpenCell, 8> run() {
    if (open_all_) measure_groups();
    find_dominators();
    if (open_all_) {
      for (std::size_t i = 0; i < scratch_.groups.size(); ++i) {
        sift_group(scratch_.groups[i], scratch_.distances[i], wanted_);
      }
    } else {
      for (const Candidate& candidate : parent_.list) sift(candidate, wanted_);
    }
    for (std::size_t child = 0; child < 8; ++child) {
      children_[child].list.assign(scratch_.lists[child].begin(), scratch_.lists[child].end());
    }
    return std::move(children_);
  }

 private:
  /// Takes the list apart to groups, measures them all, and notes what is closest to each sample.
  void measure_groups() {
    scratch_.groups.clear();
    for (const Candidate& candidate : parent_.list) {
      walk(
          space_.bvh, candidate.node, [](std::uint32_t) { return true; },
          [&](std::uint32_t node) {
            scratch_.groups.push_back({node, 0, {}, candidate.lanes});
            return true;
          });
    }
    if (scratch_.distances.size() < scratch_.groups.size()) scratch_.distances.resize(scratch_.groups.size());
    scratch_.nearest.clear();
    for (std::size_t i = 0; i < scratch_.groups.size(); ++i) {
      const std::uint32_t number = space_.bvh.nodes[scratch_.groups[i].node].first_group;
      squared_distances_below(samples_, space_.triangles.group(number), scratch_.distances[i]);
      scratch_.nearest.add(scratch_.distances[i], number);
    }
  }

  /// The surface point closest to a sample, by estimate. The parent's dominators bound the search from the
  /// start.
  Vec3 closest_to(std::size_t sample) const {
    const Vec3 p = samples_.point(sample);
    std::uint32_t slot = open_all_ ? scratch_.nearest.slot(sample) : no_index;
    std::size_t best = 0;
    if (!open_all_) {
      Search<Nearest> search(space_, p, lattice_.reach(), Nearest{});
      for (std::size_t k = 0; k < dominator_count; ++k) {
        const double away = distance_between(p, parent_.dominators[k]);
        if (away * away < search.least()) best = k;
        search.bound(away * away);
      }
      search.accept().squared = search.least();
      search.descend(0);
      slot = search.accept().slot;
    }
    if (slot == no_index) return parent_.dominators[best];
    return estimate_closest(p, space_.triangles.group(slot / std::uint32_t{group_size}), slot % group_size);
  }

  void find_dominators() {
    std::array<Vec3, sample_count> closest{};
    std::array<bool, sample_count> known{};
    // The parent's corners and centre are samples too, and their closest points its dominators.
    closest[parents_centre] = parent_.dominators[0];
    known[parents_centre] = parent_.cell.level > -virtual_levels;
    for (std::size_t corner = 0; corner < 8; ++corner) {
      closest[corner_sample(corner, corner)] = parent_.dominators[1 + corner];
      known[corner_sample(corner, corner)] = parent_.cell.level > -virtual_levels;
    }
    const auto at = [&](std::size_t sample) -> const Vec3& {
      if (!known[sample]) {
        closest[sample] = closest_to(sample);
        known[sample] = true;
      }
      return closest[sample];
    };
    for (std::size_t child = 0; child < 8; ++child) {
      if ((wanted_ >> child & 1U) == 0) continue;
      Dominators& dominators = children_[child].dominators;
      dominators.fill(at(centre_sample(child)));
      bands_[child] = band_threshold(lattice_, children_[child].cell.level,
                                     distance_between(samples_.point(centre_sample(child)), dominators[0]));
      if (options_.lists == Lists::band) continue;
      std::array<Vec3, 8> corners;
      for (std::size_t corner = 0; corner < 8; ++corner) {
        corners[corner] = samples_.point(corner_sample(child, corner));
        dominators[1 + corner] = at(corner_sample(child, corner));
      }
      scratch_.rules[child] = CornerDominance(lattice_, corners, dominators);
    }
  }

  /// Drops a node from the children that cannot need it; what is left is kept whole, opened or taken apart.
  void sift(const Candidate& candidate, unsigned children) {
    const BvhNode& node = space_.bvh.nodes[candidate.node];
    const std::array<double, sample_count> squared = squared_distances_below(samples_, node.box);
    children = surviving(squared, children);
    if (children == 0) return;
    if (node.is_group()) {
      SampleDistances distances;
      squared_distances_below(samples_, space_.triangles.group(node.first_group), distances);
      sift_group(candidate, distances, children);
    } else if (diagonal_above(node.box) > size_ / 4) {
      sift({space_.bvh.left(candidate.node), 0, {}, 0xff}, children);
      sift({space_.bvh.right(candidate.node), 0, {}, 0xff}, children);
    } else {
      for (std::size_t child = 0; child < 8; ++child) {
        if ((children >> child & 1U) == 0) continue;
        keep(child, candidate.node, {0xff, 0, squared[centre_sample(child)], from_corners(squared, child)},
             triangles_below(node));
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
        drop = scratch_.rules[child].drops(from_corners(squared, child));
      }
      if (drop) children &= ~(1U << child);
    }
    return children;
  }

  void sift_group(const Candidate& candidate, const SampleDistances& distances, unsigned children) {
    const std::uint32_t number = space_.bvh.nodes[candidate.node].first_group;
    const std::uint8_t lanes = candidate.lanes & space_.triangles.own_lanes(number);
    std::array<KeptLanes, 8> kept;
    if (options_.lists == Lists::band) {
      for (std::size_t child = 0; child < 8; ++child) kept[child] = in_band(child, distances, lanes);
    } else {
      sift_lanes(scratch_.rules, distances, lanes, children, kept);
    }
    for (std::size_t child = 0; child < 8; ++child) {
      if ((children >> child & 1U) == 0 || kept[child].count == 0) continue;
      keep(child, candidate.node, kept[child], kept[child].count);
    }
  }

  KeptLanes in_band(std::size_t child, const SampleDistances& distances, std::uint8_t lanes) const {
    KeptLanes kept;
    const GroupDistances& centre = distances.squared[centre_sample(child)];
    for (std::size_t lane = 0; lane < group_size; ++lane) {
      if ((lanes >> lane & 1U) == 0 || centre[lane] > bands_[child]) continue;
      kept.lanes |= static_cast<std::uint8_t>(1U << lane);
      ++kept.count;
      kept.least_squared = std::min(kept.least_squared, centre[lane]);
      for (std::size_t corner = 0; corner < 8; ++corner) {
        double& closest = kept.corners_squared[corner];
        closest = std::min(closest, distances.squared[corner_sample(child, corner)][lane]);
      }
    }
    return kept;
  }

  void keep(std::size_t child, std::uint32_t node, const KeptLanes& kept, std::uint64_t triangles) {
    // One part in 2^50 less covers the root.
    const double distance = std::sqrt(std::max(kept.least_squared, 0.0)) * (1 - 0x1p-50);
    // Quotients by the edge, a power of two, are exact.
    const float in_edges = Entry::kept(distance / lattice_.edge);
    const EntryBound bound = entry_bound(kept.corners_squared, in_edges * lattice_.edge, size_);
    scratch_.lists[child].push_back({node, in_edges, bound, kept.lanes});
    children_[child].triangles += triangles;
  }

  static std::array<double, 8> from_corners(const std::array<double, sample_count>& squared,
                                            std::size_t child) noexcept {
    std::array<double, 8> corners;
    for (std::size_t corner = 0; corner < 8; ++corner)
      corners[corner] = squared[corner_sample(child, corner)];
    return corners;
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
  RefineScratch& scratch_;
  double size_ = 0;
  bool open_all_ = false;
  unsigned wanted_ = 0;
  Samples samples_;
  std::array<OpenCell, 8> children_;
  std::array<double, 8> bands_{};
};

}  // namespace

OpenCell root_cell(SearchSpace space) {
  OpenCell root;
  root.list.push_back({0, 0, {}, 0xff});
  root.triangles = space.triangles.size();
  root.dominators.fill(space.triangles.shape(0).vertices[0]);
  return root;
}

std::array<OpenCell, 8> refine(SearchSpace space, const Lattice& lattice, const OpenCell& parent,
                               const RefineOptions& options, RefineScratch& scratch) {
  return Refinement(space, lattice, parent, options, scratch).run();
}

}  // namespace cdfr
