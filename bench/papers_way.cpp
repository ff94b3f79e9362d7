#include "papers_way.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <vector>

namespace cdfr::bench {
namespace {

constexpr double half_diagonal_of_unit = 0.8660254037844387;
/// Pairs of sub-voxel and triangle that are timed.
constexpr double most_timed = 2e7;

double dot(const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Vec3 minus(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Vec3 on(const Vec3& from, const Vec3& way, double t) {
  return {from.x + t * way.x, from.y + t * way.y, from.z + t * way.z};
}

/// The textbook's: by the regions of the triangle's plane (Ericson 2004, 5.1.5).
double squared_distance(const Vec3& p, const std::array<Vec3, 3>& t) {
  const Vec3 ab = minus(t[1], t[0]), ac = minus(t[2], t[0]), ap = minus(p, t[0]);
  const double d1 = dot(ab, ap), d2 = dot(ac, ap);
  const auto to = [&](const Vec3& q) { return dot(minus(p, q), minus(p, q)); };
  if (d1 <= 0 && d2 <= 0) return dot(ap, ap);
  const Vec3 bp = minus(p, t[1]);
  const double d3 = dot(ab, bp), d4 = dot(ac, bp);
  if (d3 >= 0 && d4 <= d3) return dot(bp, bp);
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return to(on(t[0], ab, d1 / (d1 - d3)));
  const Vec3 cp = minus(p, t[2]);
  const double d5 = dot(ab, cp), d6 = dot(ac, cp);
  if (d6 >= 0 && d5 <= d6) return dot(cp, cp);
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return to(on(t[0], ac, d2 / (d2 - d6)));
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 >= d3 && d5 >= d6)
    return to(on(t[1], minus(t[2], t[1]), (d4 - d3) / ((d4 - d3) + (d5 - d6))));
  const double scale = 1 / (va + vb + vc);
  return to(on(on(t[0], ab, vb * scale), ac, vc * scale));
}

struct Straddling {
  Leaf leaf;
  double pairs;  ///< of sub-voxels and triangles
};

Vec3 centre_of(const Box& b) { return {(b.lo.x + b.hi.x) / 2, (b.lo.y + b.hi.y) / 2, (b.lo.z + b.hi.z) / 2}; }

/// Sub-voxels whose half diagonal is below the tolerance.
std::vector<Straddling> straddling_leaves(const Field& field, double distance, double tolerance) {
  std::vector<Straddling> found;
  field.for_each_leaf([&](const Leaf& leaf) {
    const double size = leaf.box.hi.x - leaf.box.lo.x, half_diagonal = half_diagonal_of_unit * size;
    if (std::fabs(field.distance(centre_of(leaf.box)) - distance) > half_diagonal) return;
    const double along = std::floor(half_diagonal / tolerance) + 1;
    const double pairs = along * along * along * static_cast<double>(leaf.triangles.size());
    found.push_back({leaf, pairs});
  });
  return found;
}

}  // namespace

double papers_way_seconds(const Field& field, const Mesh& mesh, double distance, double tolerance) {
  const std::vector<Straddling> leaves = straddling_leaves(field, distance, tolerance);
  double all = 0, timed = 0, kept = 0;
  for (const Straddling& s : leaves) all += s.pairs;
  const auto start = std::chrono::steady_clock::now();
  for (const Straddling& s : leaves) {
    if (timed > most_timed) break;
    std::vector<std::array<Vec3, 3>> triangles;
    for (const std::uint32_t t : s.leaf.triangles) {
      const Triangle& corners = mesh.triangles[t];
      triangles.push_back({mesh.vertices[corners[0]], mesh.vertices[corners[1]], mesh.vertices[corners[2]]});
    }
    const double size = s.leaf.box.hi.x - s.leaf.box.lo.x;
    const int along = std::min(16, static_cast<int>(half_diagonal_of_unit * size / tolerance) + 1);
    for (int i = 0; i < along * along * along; ++i) {
      const auto at = [&](double lo, int k) { return lo + size * (k + 0.5) / along; };
      const Vec3 p{at(s.leaf.box.lo.x, i % along), at(s.leaf.box.lo.y, i / along % along),
                   at(s.leaf.box.lo.z, i / along / along)};
      double least = HUGE_VAL;
      for (const auto& t : triangles) least = std::min(least, squared_distance(p, t));
      kept += std::fabs(std::sqrt(least) - std::fabs(distance)) <= tolerance / 2;
    }
    timed += static_cast<double>(along) * along * along * static_cast<double>(triangles.size());
  }
  benchmark::DoNotOptimize(kept);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return timed > 0 ? seconds * all / timed : 0;
}

}  // namespace cdfr::bench
