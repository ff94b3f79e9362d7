#include "parts/depth_probe.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <utility>

namespace cdfr::test {
namespace {

constexpr double root3 = 1.7320508075688774;

Vec3 minus(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
double dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Vec3 cross(Vec3 a, Vec3 b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }

double squared_to_segment(Vec3 p, Vec3 a, Vec3 b) {
  const Vec3 ab = minus(b, a);
  const Vec3 ap = minus(p, a);
  const double share = std::clamp(dot(ap, ab) / dot(ab, ab), 0.0, 1.0);
  const Vec3 rest{ap.x - share * ab.x, ap.y - share * ab.y, ap.z - share * ab.z};
  return dot(rest, rest);
}

/// The squared distance, or `best` if that is less.
double squared_to_triangle(Vec3 p, Vec3 a, Vec3 b, Vec3 c, double best) {
  const Vec3 normal = cross(minus(b, a), minus(c, a));
  const double height = dot(minus(p, a), normal);
  const double length = dot(normal, normal);
  if (height * height >= best * length) return best;
  const auto on_left = [&](Vec3 from, Vec3 to) {
    return dot(cross(minus(to, from), minus(p, from)), normal) >= 0;
  };
  if (on_left(a, b) && on_left(b, c) && on_left(c, a)) return height * height / length;
  return std::min(
      {best, squared_to_segment(p, a, b), squared_to_segment(p, b, c), squared_to_segment(p, c, a)});
}

double coordinate(Vec3 v, std::size_t axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

}  // namespace

DepthProbe::DepthProbe(const Mesh& mesh, double size)
    : mesh_(mesh), size_(size), box_{mesh.vertices[0], mesh.vertices[0]} {
  for (const Vec3& v : mesh.vertices) {
    box_.lo = {std::min(box_.lo.x, v.x), std::min(box_.lo.y, v.y), std::min(box_.lo.z, v.z)};
    box_.hi = {std::max(box_.hi.x, v.x), std::max(box_.hi.y, v.y), std::max(box_.hi.z, v.z)};
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    counts_[axis] =
        1 + static_cast<std::size_t>((coordinate(box_.hi, axis) - coordinate(box_.lo, axis)) / size);
  }
  buckets_.resize(counts_[0] * counts_[1] * counts_[2]);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    std::array<std::size_t, 3> low{}, high{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto [i, j, k] = mesh.triangles[t];
      const auto [least, most] = std::minmax({slot(coordinate(mesh.vertices[i], axis), axis),
                                              slot(coordinate(mesh.vertices[j], axis), axis),
                                              slot(coordinate(mesh.vertices[k], axis), axis)});
      low[axis] = least;
      high[axis] = most;
    }
    for (std::size_t z = low[2]; z <= high[2]; ++z) {
      for (std::size_t y = low[1]; y <= high[1]; ++y) {
        for (std::size_t x = low[0]; x <= high[0]; ++x)
          buckets_[(z * counts_[1] + y) * counts_[0] + x].push_back(t);
      }
    }
  }
}

std::size_t DepthProbe::slot(double value, std::size_t axis) const {
  const double place = (value - coordinate(box_.lo, axis)) / size_;
  return static_cast<std::size_t>(std::clamp(place, 0.0, static_cast<double>(counts_[axis] - 1)));
}

const std::vector<std::uint32_t>& DepthProbe::bucket(std::size_t x, std::size_t y, std::size_t z) const {
  return buckets_[(z * counts_[1] + y) * counts_[0] + x];
}

/// The buckets whose largest step from the point's own is `ring`.
double DepthProbe::nearest_in_shell(Vec3 p, int ring, double best) const {
  std::array<int, 3> at{}, last{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    at[axis] = static_cast<int>(slot(coordinate(p, axis), axis));
    last[axis] = static_cast<int>(counts_[axis]) - 1;
  }
  for (int z = std::max(0, at[2] - ring); z <= std::min(last[2], at[2] + ring); ++z) {
    for (int y = std::max(0, at[1] - ring); y <= std::min(last[1], at[1] + ring); ++y) {
      const bool whole_row = std::max(std::abs(z - at[2]), std::abs(y - at[1])) == ring;
      for (int x = at[0] - ring; x <= at[0] + ring; x += whole_row || ring == 0 ? 1 : 2 * ring) {
        if (x < 0 || x > last[0]) continue;
        for (const std::uint32_t t :
             bucket(static_cast<std::size_t>(x), static_cast<std::size_t>(y), static_cast<std::size_t>(z))) {
          const auto [i, j, k] = mesh_.triangles[t];
          best = squared_to_triangle(p, mesh_.vertices[i], mesh_.vertices[j], mesh_.vertices[k], best);
        }
      }
    }
  }
  return best;
}

double DepthProbe::distance(Vec3 p) const { return distance(p, 0, std::numeric_limits<double>::infinity()); }

/// A triangle first met in ring r + 1 is at least r bucket edges away, for a point in the box.
double DepthProbe::distance(Vec3 p, double enough, double far) const {
  double best = std::numeric_limits<double>::infinity();
  const int rings = static_cast<int>(std::max({counts_[0], counts_[1], counts_[2]}));
  for (int ring = 0; ring <= rings; ++ring) {
    const double known = std::max(0, ring - 1) * size_;
    if (best <= std::max(known * known, enough * enough) || known > far) break;
    best = nearest_in_shell(p, ring, best);
  }
  return std::sqrt(best);
}

std::vector<std::pair<double, bool>> DepthProbe::crossings(double x, double y) const {
  std::vector<std::uint32_t> candidates;
  for (std::size_t z = 0; z < counts_[2]; ++z) {
    const auto& part = bucket(slot(x, 0), slot(y, 1), z);
    candidates.insert(candidates.end(), part.begin(), part.end());
  }
  std::sort(candidates.begin(), candidates.end());
  candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());
  std::vector<std::pair<double, bool>> result;
  for (const std::uint32_t t : candidates) {
    const Vec3 a = mesh_.vertices[mesh_.triangles[t][0]];
    const Vec3 b = mesh_.vertices[mesh_.triangles[t][1]];
    const Vec3 c = mesh_.vertices[mesh_.triangles[t][2]];
    const auto side = [&](Vec3 u, Vec3 v) { return (v.x - u.x) * (y - u.y) - (v.y - u.y) * (x - u.x); };
    const double p = side(b, c);
    const double q = side(c, a);
    const double r = side(a, b);
    const bool up = p > 0 && q > 0 && r > 0;
    if (up || (p < 0 && q < 0 && r < 0)) result.emplace_back((p * a.z + q * b.z + r * c.z) / (p + q + r), up);
  }
  std::sort(result.begin(), result.end());
  return result;
}

bool DepthProbe::inside(Vec3 p) const {
  std::size_t above = 0;
  for (const auto& [z, up] : crossings(p.x, p.y)) above += z > p.z ? 1U : 0U;
  return above % 2 == 1;
}

bool DepthProbe::alternates(double x, double y) const {
  bool expected = false;
  for (const auto& [z, up] : crossings(x, y)) {
    if (up != expected) return false;
    expected = !expected;
  }
  return !expected;
}

/// Cubes over the box, shifted by odd amounts so that no line upward from a centre meets an edge.
std::vector<DepthProbe::Cube> DepthProbe::start() const {
  std::vector<Cube> cubes;
  const double half = size_ / 2;
  const Vec3 low{box_.lo.x - size_ * 0.01237, box_.lo.y - size_ * 0.01713, box_.lo.z - size_ * 0.01451};
  for (double x = low.x; x < box_.hi.x; x += size_) {
    for (double y = low.y; y < box_.hi.y; y += size_) {
      for (double z = low.z; z < box_.hi.z; z += size_)
        cubes.push_back({{x + half, y + half, z + half}, half});
    }
  }
  return cubes;
}

void DepthProbe::split(const Cube& cube, std::vector<Cube>& stack) {
  const double q = cube.half / 2;
  for (const double z : {-q, q}) {
    for (const double y : {-q, q}) {
      for (const double x : {-q, q})
        stack.push_back({{cube.centre.x + x, cube.centre.y + y, cube.centre.z + z}, q});
    }
  }
}

std::vector<DepthProbe::Place> DepthProbe::deeper_than(double bound, double finest) const {
  std::vector<Place> places;
  std::vector<Cube> stack = start();
  while (!stack.empty()) {
    const Cube cube = stack.back();
    stack.pop_back();
    const double reach = cube.half * root3;
    const double depth = distance(cube.centre, std::max(0.0, bound - reach), std::max(bound, reach));
    if (depth + reach <= bound || (depth > reach && !inside(cube.centre))) continue;
    if (2 * cube.half <= finest) {
      places.push_back({cube.centre, depth});
    } else {
      split(cube, stack);
    }
  }
  return places;
}

void DepthProbe::expect_alternating(int places) const {
  std::mt19937_64 random(4);
  const auto between = [&](double lo, double hi) {
    return lo + (hi - lo) * static_cast<double>(random() >> 11U) * 0x1p-53;
  };
  for (int i = 0; i < places; ++i) {
    const double x = between(box_.lo.x, box_.hi.x), y = between(box_.lo.y, box_.hi.y);
    ASSERT_TRUE(alternates(x, y)) << x << " " << y;
  }
}

}  // namespace cdfr::test
