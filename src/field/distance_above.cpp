#include "field/distance_above.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

#include "field/wall.h"
#include "field/query.h"
#include "geometry/query_range.h"

namespace cdfr {
namespace {

using AtCorners = std::array<double, 8>;

Vec3 corner_of(const Vec3& lo, double size, std::size_t corner) noexcept {
  return {lo.x + (corner & 1 ? size : 0), lo.y + (corner & 2 ? size : 0), lo.z + (corner & 4 ? size : 0)};
}

double largest_mean(std::span<const AtCorners> distances) noexcept {
  double largest = 0;
  for (std::size_t corner = 0; corner < 8; ++corner) {
    double sum = 0;
    for (const AtCorners& d : distances) sum += d[corner];
    largest = std::max(largest, sum);
  }
  return largest / static_cast<double>(distances.size());
}

/// Slots of the base triangles of the box's centre and corners, each once.
class BaseTriangles {
 public:
  BaseTriangles(const FieldData& field, const std::array<Vec3, 8>& corners, const Vec3& centre) noexcept {
    add(field, centre);
    for (const Vec3& corner : corners) add(field, corner);
  }
  std::span<const std::uint32_t> slots() const noexcept { return std::span(slots_).first(count_); }

 private:
  void add(const FieldData& field, const Vec3& x) noexcept {
    const std::uint32_t slot = find_closest(field, x).winner.slot;
    const auto end = slots_.begin() + static_cast<std::ptrdiff_t>(count_);
    if (std::find(slots_.begin(), end, slot) == end) slots_[count_++] = slot;
  }

  std::array<std::uint32_t, 9> slots_{};
  std::size_t count_ = 0;
};

}  // namespace

double distance_above(const FieldData& field, const Vec3& lo, double size) noexcept {
  std::array<Vec3, 8> corners;
  for (std::size_t corner = 0; corner < 8; ++corner)
    corners[corner] = without_dust(corner_of(lo, size, corner));
  const BaseTriangles base(field, corners, without_dust({lo.x + size / 2, lo.y + size / 2, lo.z + size / 2}));
  const std::span<const std::uint32_t> slots = base.slots();
  // Nine triangles and at most 36 walls.
  std::array<AtCorners, 45> distances;
  std::size_t count = 0;
  for (std::size_t i = 0; i < slots.size(); ++i) {
    const TriangleShape shape = field.triangles.shape(slots[i]);
    AtCorners& d = distances[count++];
    for (std::size_t corner = 0; corner < 8; ++corner)
      d[corner] = square_root(measure(corners[corner], shape).squared);
    for (std::size_t j = 0; j < i; ++j) {
      const auto wall = wall_heights(shape, field.triangles.shape(slots[j]), corners);
      if (wall) distances[count++] = *wall;
    }
  }
  double bound = largest_mean(std::span<const AtCorners>(distances).first(count));
  for (std::size_t i = 0; i < count; ++i) {
    bound = std::min(bound, largest_mean(std::span<const AtCorners>(distances).subspan(i, 1)));
    for (std::size_t j = i + 1; j < count; ++j) {
      bound = std::min(bound, largest_mean(std::array{distances[i], distances[j]}));
    }
  }
  return bound;
}

}  // namespace cdfr
