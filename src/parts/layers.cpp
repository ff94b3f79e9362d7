#include "parts/layers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <utility>

#include "parts/plan.h"

namespace cdfr {
namespace {

/// The steps' heights, and equal parts between them.
std::vector<double> make_levels(std::span<const Step> steps, double layer) {
  const std::vector<double> heights = heights_of(steps);
  std::vector<double> levels{heights.front()};
  for (std::size_t i = 0; i + 1 < heights.size(); ++i) {
    const double gap = heights[i + 1] - heights[i];
    const int parts = std::max(1, static_cast<int>(std::ceil(gap / layer)));
    for (int k = 1; k < parts; ++k) levels.push_back(heights[i] + gap * k / parts);
    levels.push_back(heights[i + 1]);
  }
  return levels;
}

/// Bit k of a triangle's mask: its cell in layer k is solid.
std::vector<std::uint64_t> fill_cells(const Plan& plan, std::span<const Step> steps,
                                      const std::vector<double>& levels) {
  std::vector<std::uint64_t> masks(plan.triangles.size(), 0);
  for (const Step& step : steps) {
    const std::uint64_t layers = layers_of(step, levels);
    for (std::size_t t = 0; t < masks.size(); ++t) {
      const auto [a, b, c] = plan.triangles[t];
      if (!holds_middle(step.outline, plan.points[a], plan.points[b], plan.points[c])) continue;
      masks[t] = step.solid ? masks[t] | layers : masks[t] & ~layers;
    }
  }
  return masks;
}

/// The mask across each triangle's three sides, 0 beyond the footprint.
std::vector<std::array<std::uint64_t, 3>> masks_beside(const Plan& plan,
                                                       const std::vector<std::uint64_t>& masks) {
  struct Side {
    std::uint32_t low, high, triangle;
    std::size_t place;
  };
  std::vector<Side> sides;
  for (std::uint32_t t = 0; t < plan.triangles.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax(plan.triangles[t][i], plan.triangles[t][(i + 1) % 3]);
      sides.push_back({low, high, t, i});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
  });
  std::vector<std::array<std::uint64_t, 3>> beside(plan.triangles.size(), {0, 0, 0});
  for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
    const Side& a = sides[i];
    const Side& b = sides[i + 1];
    if (a.low != b.low || a.high != b.high) continue;
    beside[a.triangle][a.place] = masks[b.triangle];
    beside[b.triangle][b.place] = masks[a.triangle];
  }
  return beside;
}

/// Collects the border; a vertex is made when a triangle first uses it.
class Border {
 public:
  Border(const Plan& plan, const std::vector<double>& levels, const LayerOptions& options)
      : plan_(plan),
        levels_(levels),
        options_(options),
        numbers_(plan.points.size() * levels.size(), no_index) {}

  void add_floor(std::size_t triangle, std::size_t level, bool faces_up) {
    auto [a, b, c] = plan_.triangles[triangle];
    if (!faces_up) std::swap(b, c);
    mesh_.triangles.push_back({vertex(a, level), vertex(b, level), vertex(c, level)});
  }

  /// The wall over the side from a to b of a solid cell in the layer above `level`; void is on its right.
  void add_wall(std::uint32_t a, std::uint32_t b, std::size_t level) {
    const std::uint32_t a_low = vertex(a, level);
    const std::uint32_t b_low = vertex(b, level);
    const std::uint32_t a_high = vertex(a, level + 1);
    const std::uint32_t b_high = vertex(b, level + 1);
    if ((a < b) == (level % 2 == 0)) {
      mesh_.triangles.push_back({a_low, b_low, b_high});
      mesh_.triangles.push_back({a_low, b_high, a_high});
    } else {
      mesh_.triangles.push_back({a_low, b_low, a_high});
      mesh_.triangles.push_back({b_low, b_high, a_high});
    }
  }

  Mesh take() { return std::move(mesh_); }

 private:
  std::uint32_t vertex(std::uint32_t point, std::size_t level) {
    std::uint32_t& number = numbers_[point * levels_.size() + level];
    if (number == no_index) {
      number = static_cast<std::uint32_t>(mesh_.vertices.size());
      const double x = static_cast<double>(plan_.points[point].x) / plan_units;
      const double y = static_cast<double>(plan_.points[point].y) / plan_units;
      const double z = options_.lift == nullptr ? levels_[level] : options_.lift(x, y, levels_[level]);
      mesh_.vertices.push_back({x, y, z});
    }
    return number;
  }

  const Plan& plan_;
  const std::vector<double>& levels_;
  const LayerOptions& options_;
  std::vector<std::uint32_t> numbers_;
  Mesh mesh_;
};

}  // namespace

Mesh build_layers(std::span<const Step> steps, const LayerOptions& options) {
  std::vector<Outline> outlines;
  for (const Step& step : steps) outlines.push_back(step.outline);
  const Plan plan = make_plan(plan_point(options.size.x, options.size.y), outlines, options.spacing);
  const std::vector<double> levels = make_levels(steps, options.layer);
  const std::vector<std::uint64_t> masks = fill_cells(plan, steps, levels);
  const auto beside = masks_beside(plan, masks);
  Border border(plan, levels, options);
  for (std::size_t t = 0; t < plan.triangles.size(); ++t) {
    const auto solid = [&](std::uint64_t mask, std::size_t layer) { return ((mask >> layer) & 1U) != 0; };
    for (std::size_t k = 0; k + 1 < levels.size(); ++k) {
      if (!solid(masks[t], k)) continue;
      if (k == 0 || !solid(masks[t], k - 1)) border.add_floor(t, k, false);
      if (k + 2 == levels.size() || !solid(masks[t], k + 1)) border.add_floor(t, k + 1, true);
      for (std::size_t i = 0; i < 3; ++i) {
        if (solid(beside[t][i], k)) continue;
        border.add_wall(plan.triangles[t][i], plan.triangles[t][(i + 1) % 3], k);
      }
    }
  }
  return border.take();
}

}  // namespace cdfr
