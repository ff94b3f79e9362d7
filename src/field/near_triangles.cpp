#include "field/near_triangles.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/vector.h"
#include "geometry/box_distance.h"
#include "geometry/cube.h"

namespace cdfr {
namespace {

/// Far above what plain_foot and the sums below are off by.
constexpr double rounding_share = 0x1p-36;

double radius_of(double distance, double size) noexcept {
  return (distance + 2 * Cube{{}, size}.half_diagonal()) * (1 + rounding_share);
}

/// Drops what the closest one's foot dominates at all corners.
void thin(const Eigen::Vector3d& centre, double size, double distance, std::vector<NearTriangle>& near) {
  std::size_t closest = 0;
  for (std::size_t i = 1; i < near.size(); ++i) {
    if (near[i].foot.distance < near[closest].foot.distance) closest = i;
  }
  const PlainFoot foot = near[closest].foot;
  std::array<Eigen::Vector3d, 8> offsets;
  std::array<double, 8> reached;
  for (std::size_t corner = 0; corner < 8; ++corner) {
    const double half = size / 2;
    offsets[corner] = {corner & 1 ? half : -half, corner & 2 ? half : -half, corner & 4 ? half : -half};
    reached[corner] = (offsets[corner] + foot.gradient * foot.distance).norm();
  }
  const double rounding = rounding_share * (distance + size + centre.lpNorm<Eigen::Infinity>() * 0x1p-10);
  std::erase_if(near, [&](const NearTriangle& t) {
    for (std::size_t corner = 0; corner < 8; ++corner) {
      if (t.foot.distance + t.foot.gradient.dot(offsets[corner]) <= reached[corner] + rounding) return false;
    }
    return true;
  });
}

}  // namespace

bool near_triangles(const FieldData& field, const Eigen::Vector3d& centre, double size,
                    std::span<const std::uint32_t> candidates, std::vector<NearTriangle>& near) {
  near.clear();
  double least = HUGE_VAL;
  for (const std::uint32_t slot : candidates) {
    near.push_back({slot, plain_foot(centre, field.triangles.shape(slot))});
    least = std::min(least, near.back().foot.distance);
  }
  if (near.empty()) return true;
  const double radius = radius_of(least, size);
  std::erase_if(near, [&](const NearTriangle& t) { return t.foot.distance > radius; });
  thin(centre, size, least, near);
  return true;
}

bool near_triangles(const FieldData& field, const Eigen::Vector3d& centre, double size, double distance,
                    std::vector<NearTriangle>& near) {
  near.clear();
  const double radius = radius_of(distance, size);
  const Vec3 c = from_eigen(centre);
  const bool all = walk(
      field.bvh, 0,
      [&](std::uint32_t node) {
        return squared_distance_below(c, field.bvh.nodes[node].box) <= radius * radius;
      },
      [&](std::uint32_t node) {
        const std::uint32_t group = field.bvh.nodes[node].first_group;
        for (std::size_t lane = 0; lane < field.triangles.lanes(group); ++lane) {
          const auto slot = static_cast<std::uint32_t>(group * group_size + lane);
          const PlainFoot foot = plain_foot(centre, field.triangles.shape(slot));
          if (foot.distance <= radius) near.push_back({slot, foot});
        }
        return near.size() <= most_near;
      });
  if (!all || near.empty()) return all;
  thin(centre, size, distance, near);
  return true;
}

}  // namespace cdfr
