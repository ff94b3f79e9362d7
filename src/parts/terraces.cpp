#include "parts/terraces.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "parts/prism.h"
#include "parts/triangulation.h"

namespace cdfr {
namespace {

/// An outline of the recipe; its place in the plan is what it encloses, less the outlines in it. The first
/// region is the plan beyond all outlines.
struct Region {
  Outline outline;
  std::size_t parent = 0;
  std::uint64_t solid = 0;  ///< bit k: between levels k and k + 1
};

std::int64_t twice_area(const Outline& outline) noexcept {
  std::int64_t sum = 0;
  for (std::size_t i = 1; i + 1 < outline.size(); ++i) sum += turn(outline[0], outline[i], outline[i + 1]);
  return sum;
}

bool holds(const Outline& outline, PlanPoint point) noexcept {
  return holds_middle(outline, point, point, point);
}

/// Outlines come after those that they lie in.
std::vector<Region> make_regions(std::span<const Step> steps) {
  std::vector<Outline> outlines;
  for (const Step& step : steps) {
    if (std::find(outlines.begin(), outlines.end(), step.outline) == outlines.end()) {
      outlines.push_back(step.outline);
    }
  }
  std::stable_sort(outlines.begin(), outlines.end(),
                   [](const Outline& a, const Outline& b) { return twice_area(a) > twice_area(b); });
  std::vector<Region> regions(1);
  for (Outline& outline : outlines) {
    std::size_t parent = regions.size() - 1;
    while (parent > 0 && !holds(regions[parent].outline, outline.front())) --parent;
    regions.push_back({std::move(outline), parent});
  }
  return regions;
}

void fill_regions(std::vector<Region>& regions, std::span<const Step> steps, std::span<const double> levels) {
  for (const Step& step : steps) {
    const std::uint64_t layers = layers_of(step, levels);
    for (std::size_t i = 1; i < regions.size(); ++i) {
      Region& region = regions[i];
      if (!holds(step.outline, region.outline.front())) continue;
      region.solid = step.solid ? region.solid | layers : region.solid & ~layers;
    }
  }
}

class Terraces {
 public:
  Terraces(std::span<const Step> steps, double scale)
      : levels_(heights_of(steps)), regions_(make_regions(steps)), scale_(scale) {
    fill_regions(regions_, steps, levels_);
  }

  Mesh border() {
    for (std::size_t region = 1; region < regions_.size(); ++region) add_walls(region);
    for (std::size_t level = 0; level < levels_.size(); ++level) {
      for (std::size_t region = 1; region < regions_.size(); ++region) {
        const int change = change_at(region, level);
        if (change != 0 && change_at(regions_[region].parent, level) != change) add_floor(region, level);
      }
    }
    return std::move(mesh_);
  }

 private:
  bool solid(std::size_t region, std::size_t layer) const noexcept {
    return layer < levels_.size() - 1 && ((regions_[region].solid >> layer) & 1U) != 0;
  }
  /// 1 where solid begins with height, -1 where it ends.
  int change_at(std::size_t region, std::size_t level) const noexcept {
    const bool below = level > 0 && solid(region, level - 1);
    return static_cast<int>(solid(region, level)) - static_cast<int>(below);
  }
  std::uint32_t ring(std::size_t region, std::size_t level);
  void add_walls(std::size_t region);
  void add_floor(std::size_t region, std::size_t level);

  std::vector<double> levels_;
  std::vector<Region> regions_;
  double scale_;
  std::map<std::pair<std::size_t, std::size_t>, std::uint32_t> rings_;
  Mesh mesh_;
};

/// The number of the first of the vertices that the outline has at that level.
std::uint32_t Terraces::ring(std::size_t region, std::size_t level) {
  const auto [known, made] =
      rings_.try_emplace({region, level}, static_cast<std::uint32_t>(mesh_.vertices.size()));
  if (made) {
    for (const PlanPoint point : regions_[region].outline) {
      mesh_.vertices.push_back({static_cast<double>(point.x) / (plan_units * scale_),
                                static_cast<double>(point.y) / (plan_units * scale_),
                                levels_[level] / scale_});
    }
  }
  return known->second;
}

/// Walls stand where just one side of the outline is solid, each over as many layers as that lasts.
void Terraces::add_walls(std::size_t region) {
  const Region& here = regions_[region];
  const auto kind = [&](std::size_t layer) {
    return static_cast<int>(solid(region, layer)) - static_cast<int>(solid(here.parent, layer));
  };
  const auto count = static_cast<std::uint32_t>(here.outline.size());
  for (std::size_t low = 0; low + 1 < levels_.size();) {
    std::size_t high = low + 1;
    while (high + 1 < levels_.size() && kind(high) == kind(low)) ++high;
    if (kind(low) > 0) cdfr::add_wall(mesh_, ring(region, low), ring(region, high), count);
    if (kind(low) < 0) cdfr::add_wall(mesh_, ring(region, high), ring(region, low), count);
    low = high;
  }
}

/// One flat face: the region and those in it that change with it.
void Terraces::add_floor(std::size_t region, std::size_t level) {
  const int change = change_at(region, level);
  std::vector<bool> part(regions_.size(), false);
  part[region] = true;
  std::vector<Outline> loops{regions_[region].outline};
  std::vector<std::uint32_t> vertices;
  const auto add_ring = [&](std::size_t of) {
    const std::uint32_t first = ring(of, level);
    for (std::uint32_t i = 0; i < regions_[of].outline.size(); ++i) vertices.push_back(first + i);
  };
  add_ring(region);
  for (std::size_t inner = region + 1; inner < regions_.size(); ++inner) {
    if (!part[regions_[inner].parent]) continue;
    assert(change_at(inner, level) != -change);
    part[inner] = change_at(inner, level) == change;
    if (part[inner]) continue;
    loops.push_back(regions_[inner].outline);
    add_ring(inner);
  }
  for (auto [a, b, c] : triangulate(loops)) {
    if (change > 0) std::swap(b, c);
    mesh_.triangles.push_back({vertices[a], vertices[b], vertices[c]});
  }
}

}  // namespace

Mesh build_terraces(std::span<const Step> steps, double scale) { return Terraces(steps, scale).border(); }

}  // namespace cdfr
