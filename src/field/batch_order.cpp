#include "field/batch_order.h"

#include <tbb/parallel_sort.h>

#include <array>

#include "core/parallel.h"
#include "geometry/box_distance.h"

namespace cdfr {
namespace {

/// Cells along an axis: with 30 bits for the place a key has room for the point's number.
constexpr int bits = 10;
constexpr std::uint64_t beyond = std::uint64_t{1} << (3 * bits);

/// Two zero bits between any two of ten.
std::uint64_t spread(std::uint64_t x) noexcept {
  x = (x | x << 16) & 0x30000ff;
  x = (x | x << 8) & 0x300f00f;
  x = (x | x << 4) & 0x30c30c3;
  return (x | x << 2) & 0x9249249;
}

}  // namespace

std::vector<std::uint32_t> along_curve(const FieldData& field, const Points& x, std::size_t first,
                                       std::size_t count) {
  const Box domain = field.tree.lattice.domain();
  const double cells = 1 << bits;
  const Vec3 scale{cells / (domain.hi.x - domain.lo.x), cells / (domain.hi.y - domain.lo.y),
                   cells / (domain.hi.z - domain.lo.z)};
  const auto place = [](double at) {
    return spread(at < (1 << bits) ? static_cast<std::uint64_t>(at) : (1 << bits) - 1);
  };
  std::vector<std::uint64_t> keys(count);
  for_chunks(count, 4096, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Vec3 p = x[first + i];
      std::uint64_t key = beyond;
      if (contains(domain, p)) {
        key = place((p.x - domain.lo.x) * scale.x) | place((p.y - domain.lo.y) * scale.y) << 1 |
              place((p.z - domain.lo.z) * scale.z) << 2;
      }
      keys[i] = key << 32 | i;
    }
  });
  tbb::parallel_sort(keys.begin(), keys.end());
  std::vector<std::uint32_t> order(count);
  for (std::size_t i = 0; i < count; ++i) order[i] = static_cast<std::uint32_t>(keys[i]);
  return order;
}

}  // namespace cdfr
