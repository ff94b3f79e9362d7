#include "contour/exclusion.h"

#include <algorithm>
#include <cmath>
#include <span>

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

}  // namespace

double distance_above(const FieldData& field, const Vec3& lo, double size) noexcept {
  std::array<std::uint32_t, 9> slots{};
  std::size_t count = 0;
  const auto add = [&](const Vec3& x) {
    const std::uint32_t slot = find_winner(field, without_dust(x)).slot;
    if (std::find(slots.begin(), slots.begin() + count, slot) == slots.begin() + count) slots[count++] = slot;
  };
  add({lo.x + size / 2, lo.y + size / 2, lo.z + size / 2});
  for (std::size_t corner = 0; corner < 8; ++corner) add(corner_of(lo, size, corner));
  std::array<AtCorners, 9> distances{};
  for (std::size_t i = 0; i < count; ++i) {
    const TriangleShape shape = field.triangles.shape(slots[i]);
    for (std::size_t corner = 0; corner < 8; ++corner) {
      distances[i][corner] = square_root(measure(without_dust(corner_of(lo, size, corner)), shape).squared);
    }
  }
  double bound = largest_mean(std::span(distances).first(count));
  for (std::size_t i = 0; i < count; ++i) {
    bound = std::min(bound, largest_mean(std::span(distances).subspan(i, 1)));
    for (std::size_t j = i + 1; j < count; ++j) {
      bound = std::min(bound, largest_mean(std::array{distances[i], distances[j]}));
    }
  }
  return bound;
}

}  // namespace cdfr
