#include "oracle/section_oracle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

namespace cdfr::oracle {
namespace {

/// A cube more than the part needs on every side, so that no neighbour of a deep sample is missing.
Grid grid_over(const Box& box, std::size_t samples) {
  const Vec3 size{box.hi.x - box.lo.x, box.hi.y - box.lo.y, box.hi.z - box.lo.z};
  const double spacing = std::cbrt(size.x * size.y * size.z / static_cast<double>(samples));
  const auto count = [&](double length) { return static_cast<std::uint32_t>(length / spacing) + 3; };
  // Off the part's own planes by a share that is no simple fraction.
  const auto from = [&](double low) { return low - 0.6180339887 * spacing; };
  return {{from(box.lo.x), from(box.lo.y), from(box.lo.z)},
          {spacing, spacing, spacing},
          {count(size.x), count(size.y), count(size.z)}};
}

}  // namespace

SectionGrid::SectionGrid(const Field& field, double depth, std::size_t samples)
    : field_(field), depth_(depth), grid_(grid_over(field.bounds(), samples)), depths_(grid_.count()) {
  field.distance(grid_, depths_).value();
  for (double& d : depths_) d = -d;
  patch_of_ = components([&](double a, double b, double) { return std::min(a, b) > depth_ - reach(); });
  part_of_ = components([&](double a, double b, double apart) {
    return std::min(a, b) > depth_ && a + b - apart > 2 * depth_;
  });
  measure();
}

double SectionGrid::reach() const noexcept { return std::sqrt(3.0) / 2 * spacing() * (1 + 1e-12); }

// A flood over the 26 neighbours of each sample. joins(a, a, 0) says whether a sample counts at all.
template <class Joins>
std::vector<std::uint32_t> SectionGrid::components(Joins joins) const {
  std::vector<std::uint32_t> component(depths_.size(), none);
  std::vector<std::size_t> open;
  std::uint32_t count = 0;
  const auto [nx, ny, nz] = grid_.size;
  const auto visit_neighbours = [&, nx = nx, ny = ny, nz = nz](std::size_t at) {
    const auto x = static_cast<std::int64_t>(at % nx), y = static_cast<std::int64_t>(at / nx % ny),
               z = static_cast<std::int64_t>(at / nx / ny);
    for (int k = 0; k < 27; ++k) {
      const std::int64_t dx = k % 3 - 1, dy = k / 3 % 3 - 1, dz = k / 9 - 1;
      if (x + dx < 0 || x + dx >= nx || y + dy < 0 || y + dy >= ny || z + dz < 0 || z + dz >= nz) continue;
      const auto next = static_cast<std::size_t>(((z + dz) * ny + y + dy) * nx + x + dx);
      const double apart = spacing() * std::sqrt(static_cast<double>(dx * dx + dy * dy + dz * dz));
      if (component[next] != none || !joins(depths_[at], depths_[next], apart)) continue;
      component[next] = component[at];
      open.push_back(next);
    }
  };
  for (std::size_t i = 0; i < depths_.size(); ++i) {
    if (component[i] != none || !joins(depths_[i], depths_[i], 0)) continue;
    component[i] = count++;
    open.push_back(i);
    while (!open.empty()) {
      const std::size_t at = open.back();
      open.pop_back();
      visit_neighbours(at);
    }
  }
  return component;
}

void SectionGrid::measure() {
  const double cube = spacing() * spacing() * spacing();
  std::vector<std::size_t> deepest;
  std::vector<std::set<std::uint32_t>> parts;
  for (std::size_t i = 0; i < depths_.size(); ++i) {
    if (patch_of_[i] == none) continue;
    const Vec3 p = grid_.point(static_cast<std::uint32_t>(i % grid_.size[0]),
                               static_cast<std::uint32_t>(i / grid_.size[0] % grid_.size[1]),
                               static_cast<std::uint32_t>(i / grid_.size[0] / grid_.size[1]));
    if (patch_of_[i] == patches_.size()) {  // the flood numbers patches by their first sample
      patches_.push_back({{}, 0, {}, p, {p, p}, 0});
      deepest.push_back(i);
      parts.emplace_back();
    }
    SectionPatch& patch = patches_[patch_of_[i]];
    const double d = depths_[i];
    patch.volume.high += cube;
    patch.counted += cube * std::clamp(0.5 + (d - depth_) / spacing(), 0.0, 1.0);
    if (d > depth_ + reach()) patch.volume.low += cube;
    if (part_of_[i] != none) parts[patch_of_[i]].insert(part_of_[i]);
    if (d > depths_[deepest[patch_of_[i]]]) deepest[patch_of_[i]] = i, patch.deepest = p;
    const double half = spacing() / 2;
    patch.box.lo = {std::min(patch.box.lo.x, p.x - half), std::min(patch.box.lo.y, p.y - half),
                    std::min(patch.box.lo.z, p.z - half)};
    patch.box.hi = {std::max(patch.box.hi.x, p.x + half), std::max(patch.box.hi.y, p.y + half),
                    std::max(patch.box.hi.z, p.z + half)};
  }
  for (std::uint32_t i = 0; i < patches_.size(); ++i) {
    patches_[i].parts = parts[i].size();
    ascend(i, deepest[i]);
  }
}

// Steps in 26 directions, halved when none goes up: a lower bound wherever it ends. It stays in the patch's
// cubes.
void SectionGrid::ascend(std::uint32_t number, std::size_t from) {
  SectionPatch& patch = patches_[number];
  double best = depths_[from];
  patch.radius.high = best + reach();
  double step = spacing();
  for (int i = 0; i < 1000 && step > 1e-9 * spacing(); ++i) {
    const Vec3 p = patch.deepest;
    const double before = best;
    for (int k = 0; k < 27; ++k) {
      const Vec3 next{p.x + step * (k % 3 - 1), p.y + step * (k / 3 % 3 - 1), p.z + step * (k / 9 - 1)};
      const double d = -field_.distance(next);
      if (d > best && this->patch(next) == number) best = d, patch.deepest = next;
    }
    step = best == before ? step / 2 : std::min(2 * step, spacing());
  }
  patch.radius.low = best > depth_ ? best : 0;
}

std::size_t SectionGrid::nearest(const Vec3& p) const {
  const auto index = [&](double x, double from, std::uint32_t count) {
    return static_cast<std::size_t>(
        std::clamp(std::round((x - from) / spacing()), 0.0, static_cast<double>(count - 1)));
  };
  const Vec3& o = grid_.origin;
  return (index(p.z, o.z, grid_.size[2]) * grid_.size[1] + index(p.y, o.y, grid_.size[1])) * grid_.size[0] +
         index(p.x, o.x, grid_.size[0]);
}

std::uint32_t SectionGrid::patch(const Vec3& p) const { return patch_of_[nearest(p)]; }
std::uint32_t SectionGrid::part(const Vec3& p) const { return part_of_[nearest(p)]; }

}  // namespace cdfr::oracle
