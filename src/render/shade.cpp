#include "render/shade.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "render/view.h"

namespace cdfr {
namespace {

using Colour = Eigen::Vector3f;

const Colour white(1, 1, 1);
const Colour warm(0.96F, 0.40F, 0.11F);
const Colour far_tint(0.72F, 0.66F, 0.66F);
const Colour glass(0.62F, 0.66F, 0.72F);
const Colour line(0.20F, 0.24F, 0.30F);

/// Unit vector to the light: from the viewer's upper left. The numbers are 6/11, 6/11 and 7/11.
const Eigen::Vector3f to_light(-6.0F / 11, -6.0F / 11, -7.0F / 11);
/// Halfway between the light and the viewer, for the highlight: (-6, -6, -18) / 6 sqrt(11).
const Eigen::Vector3f to_highlight = Eigen::Vector3f(-1, -1, -3) / std::sqrt(11.0F);

constexpr float crease_cosine = 0.87F;  // 30 degrees
constexpr float depth_step = 4;         // samples: smaller steps are no outline
constexpr std::array<std::array<int, 2>, 4> neighbours = {{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};

const Sample nothing;

const Sample& look(const Layer& layer, int column, int row) {
  return layer.holds(column, row) ? layer.at(column, row) : nothing;
}

Colour mix(const Colour& under, const Colour& over, float share) { return under + share * (over - under); }

Eigen::Vector3f normal_of(const Sample& sample) { return {sample.nx, sample.ny, sample.nz}; }

/// Change of depth to the next sample in that direction if the surface goes on flat.
float slope(const Sample& sample, int dx, int dy) {
  const float rise = -(sample.nx * static_cast<float>(dx) + sample.ny * static_cast<float>(dy));
  return rise / std::min(sample.nz, -0.02F);
}

bool breaks(const Sample& a, const Sample& b, int dx, int dy) {
  if (a.empty() || b.empty()) return a.empty() != b.empty();
  if (normal_of(a).dot(normal_of(b)) < crease_cosine) return true;
  const float slope_a = slope(a, dx, dy), slope_b = slope(b, dx, dy);
  const float surprise = std::abs(b.depth - a.depth - (slope_a + slope_b) / 2);
  return surprise > depth_step + std::abs(slope_a) + std::abs(slope_b);
}

/// Share of a drawn line at the sample: outlines and creases show as breaks between neighbouring samples.
float line_share(const Layer& layer, int column, int row) {
  const Sample& here = layer.at(column, row);
  for (const auto& [dx, dy] : neighbours) {
    if (breaks(here, look(layer, column + dx, row + dy), dx, dy)) return 1;
  }
  return 0;
}

/// Darkens a point whose neighbours are nearer to the viewer: steps and hollows stand out without a light of
/// their own.
float openness(const Layer& layer, int column, int row) {
  const Sample& here = layer.at(column, row);
  float covered = 0;
  for (const auto& [dx, dy] : neighbours) {
    const Sample& there = look(layer, column + shade_reach * dx, row + shade_reach * dy);
    if (there.empty()) continue;
    const float expected = here.depth + shade_reach * slope(here, dx, dy);
    covered += std::clamp((expected - there.depth) / 24, 0.0F, 1.0F);
  }
  return 1 / (1 + 0.6F * covered);
}

Colour point_colour(const Layer& layer, int column, int row, float depth) {
  const Sample& sample = layer.at(column, row);
  const Eigen::Vector3f normal = normal_of(sample);
  const float diffuse = std::max(0.0F, normal.dot(to_light));
  float highlight = std::max(0.0F, normal.dot(to_highlight));
  for (int i = 0; i < 5; ++i) highlight *= highlight;
  const float light = (0.36F - 0.30F * sample.nz + 0.42F * diffuse) * openness(layer, column, row);
  const Colour lit = mix((warm * light).cwiseMin(1.0F), white, 0.25F * highlight);
  const float farness = depth > 0 ? std::clamp(sample.depth / depth, -1.0F, 1.0F) / 2 + 0.5F : 0;
  return mix(lit, far_tint, 0.30F * farness);
}

/// Glass: clear where it faces the viewer, denser towards its rim.
Colour cover(const Colour& under, const Layer& layer, int column, int row, float least, float most,
             float ink) {
  const Sample& sample = layer.at(column, row);
  if (sample.empty()) return under;
  const float rim = 1 + sample.nz;
  const float light = 0.85F + 0.25F * normal_of(sample).dot(to_light);
  const Colour body = mix(under, glass * light, least + (most - least) * rim * rim);
  return mix(body, line, ink * line_share(layer, column, row));
}

}  // namespace

Colour shade(const Band& band, int column, int row, float depth) {
  const Sample& front = band.front.at(column, row);
  const Sample& point = band.points.at(column, row);
  const bool point_first = !point.empty() && point.depth < front.depth;
  if (point_first) return point_colour(band.points, column, row, depth);
  Colour colour = white;
  if (!point.empty()) {
    colour = point_colour(band.points, column, row, depth);
  } else {
    colour = cover(colour, band.back, column, row, 0.10F, 0.30F, 0.22F);
  }
  return cover(colour, band.front, column, row, 0.12F, 0.55F, 0.60F);
}

}  // namespace cdfr
