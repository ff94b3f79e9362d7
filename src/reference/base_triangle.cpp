#include "reference/base_triangle.h"

#include <cmath>
#include <limits>

#include "core/vector.h"
#include "field/query.h"
#include "geometry/query_range.h"

namespace cdfr {
namespace {

UniformClosest signed_by_base(const ReferenceSurface& surface, std::uint32_t triangle,
                              const Foot& foot) noexcept {
  const BaseTriangle base = base_triangle(surface, triangle, foot);
  const double distance = square_root(foot.squared);
  UniformClosest result;
  result.distance = base.side < 0 ? -distance : distance;
  result.triangle = triangle;
  result.base = base.number;
  result.feature = foot.place == 0 ? Feature::face : (foot.place < 4 ? Feature::edge : Feature::vertex);
  const bool by_normal = foot.place == 0 || foot.squared.hi == 0;
  const Eigen::Vector3d way =
      to_eigen(by_normal ? rounded(surface.triangles.shape(base.number).normal) : rounded(foot.offset));
  result.normal = from_eigen(way.stableNormalized());
  return result;
}

}  // namespace

BaseTriangle base_triangle(const ReferenceSurface& surface, std::uint32_t closest,
                           const Foot& foot) noexcept {
  if (foot.place == 0) return {closest, foot.along.hi > 0 ? 1 : (foot.along.hi < 0 ? -1 : 0)};
  const Eigen::Vector3d v = to_eigen(rounded(foot.offset));
  double largest = -1, product = 0;
  std::uint32_t number = no_index;
  const auto compare = [&](std::uint32_t t) {
    const double with = v.dot(to_eigen(rounded(surface.triangles.shape(t).normal)));
    if (!(std::fabs(with) > largest)) return;
    largest = std::fabs(with);
    product = with;
    number = t;
  };
  const TriangleRecord& record = surface.triangles.records[closest];
  if (foot.place < 4) {
    for (const Topology::Use& use : surface.topology.uses_of(record.edges[foot.place - 1U]))
      compare(use.triangle);
  } else {
    for (const std::uint32_t t : surface.around_vertex(record.vertices[foot.place - 4U])) compare(t);
  }
  return {number, product > 0 ? 1 : (product < 0 ? -1 : 0)};
}

UniformClosest closest_among(const ReferenceSurface& surface, const Vec3& x,
                             std::span<const CddTuple> list) noexcept {
  UniformClosest nothing;
  nothing.distance = std::numeric_limits<double>::quiet_NaN();
  if (list.empty()) return nothing;
  double size = largest_magnitude(x);
  for (const CddTuple& tuple : list) {
    for (const Vec3& v : surface.triangles.shape(tuple.triangle).vertices)
      size = std::max(size, largest_magnitude(v));
  }
  Race race(without_dust(x), surface.triangles, size);
  for (const CddTuple& tuple : list) race.challenge(tuple.triangle);
  const Winner winner = race.finding().winner;
  return signed_by_base(surface, winner.number, winner.foot);
}

UniformClosest least_positive_among(const ReferenceSurface& surface, const Vec3& x,
                                    std::span<const CddTuple> list) noexcept {
  UniformClosest best;
  best.distance = -std::numeric_limits<double>::infinity();
  for (const CddTuple& tuple : list) {
    const Foot foot = measure(without_dust(x), surface.triangles.shape(tuple.triangle));
    const UniformClosest one = signed_by_base(surface, tuple.triangle, foot);
    const bool nearer =
        one.distance > best.distance || (one.distance == best.distance && one.triangle < best.triangle);
    if (one.distance < 0 && nearer) best = one;
  }
  return best;
}

}  // namespace cdfr
