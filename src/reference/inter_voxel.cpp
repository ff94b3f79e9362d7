#include <algorithm>
#include <array>
#include <limits>

#include "core/parallel.h"
#include "reference/base_triangle.h"
#include "reference/extract.h"

namespace cdfr {
namespace {

constexpr std::size_t cells_a_task = 256;

std::array<std::size_t, 8> corners_of(const VoxelGrid& grid, const VoxelGrid::Place& p) noexcept {
  std::array<std::size_t, 8> corners{};
  for (int i = 0; i < 8; ++i) {
    corners[static_cast<std::size_t>(i)] =
        grid.number({p[0] + (i & 1), p[1] + (i >> 1 & 1), p[2] + (i >> 2)});
  }
  return corners;
}

std::vector<double> depths_at_centres(const UniformData& data, Progress& progress) {
  std::vector<double> depths(data.lists.size(), -std::numeric_limits<double>::infinity());
  for_chunks(depths.size(), cells_a_task, [&](std::size_t first, std::size_t end) {
    if (!progress.poll()) return;
    for (std::size_t cell = first; cell < end; ++cell) {
      if (data.lists[cell].empty()) continue;
      const Vec3 centre = data.grid.centre(data.grid.place(cell));
      depths[cell] = -closest_among(data.surface, centre, data.lists[cell]).distance;
    }
  });
  return depths;
}

}  // namespace

std::vector<std::size_t> inter_voxels_across(const UniformData& data, double depth, Progress& progress) {
  const std::vector<double> depths = depths_at_centres(data, progress);
  std::vector<std::size_t> found;
  VoxelGrid::Place p{};
  for (p[2] = 0; p[2] + 1 < data.grid.counts[2]; ++p[2]) {
    for (p[1] = 0; p[1] + 1 < data.grid.counts[1]; ++p[1]) {
      for (p[0] = 0; p[0] + 1 < data.grid.counts[0]; ++p[0]) {
        double least = std::numeric_limits<double>::infinity(), most = -least;
        for (const std::size_t corner : corners_of(data.grid, p)) {
          least = std::min(least, depths[corner]);
          most = std::max(most, depths[corner]);
        }
        if (least <= depth && depth <= most) found.push_back(data.grid.number(p));
      }
    }
  }
  return found;
}

std::vector<CddTuple> united_lists(const UniformData& data, std::size_t region) {
  std::vector<CddTuple> all;
  for (const std::size_t corner : corners_of(data.grid, data.grid.place(region))) {
    all.insert(all.end(), data.lists[corner].begin(), data.lists[corner].end());
  }
  std::ranges::sort(all, {}, [](const CddTuple& a) { return std::pair(a.triangle, a.distance); });
  const auto same = [](const CddTuple& a, const CddTuple& b) { return a.triangle == b.triangle; };
  all.erase(std::unique(all.begin(), all.end(), same), all.end());
  return all;
}

}  // namespace cdfr
