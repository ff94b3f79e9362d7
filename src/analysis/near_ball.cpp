#include "analysis/near_ball.h"

#include <algorithm>

#include "geometry/box_distance.h"
#include "geometry/point_triangle.h"
#include "geometry/query_range.h"

namespace cdfr {

std::vector<std::uint32_t> triangles_within(const FieldData& field, const Vec3& centre, double radius) {
  const Vec3 p = without_dust(centre);
  std::vector<std::uint32_t> numbers;
  walk(
      field.bvh, 0,
      [&](std::uint32_t node) {
        return squared_distance_below(p, field.bvh.nodes[node].box) <= radius * radius;
      },
      [&](std::uint32_t node) {
        const std::uint32_t group = field.bvh.nodes[node].first_group;
        for (std::size_t lane = 0; lane < field.triangles.lanes(group); ++lane) {
          const auto slot = static_cast<std::uint32_t>(group * group_size + lane);
          if (square_root(measure(p, field.triangles.shape(slot)).squared) <= radius)
            numbers.push_back(field.triangles.records[slot].number);
        }
        return true;
      });
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}

}  // namespace cdfr
