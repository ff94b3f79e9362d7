#include "winners.h"

#include <cstdint>
#include <set>

namespace cdfr::bench {
namespace {

/// Samples along each axis.
constexpr int samples_along = 12;

}  // namespace

std::size_t winners(const Field& field, const Box& box) {
  std::set<std::uint32_t> found;
  const auto at = [](double lo, double hi, int i) { return lo + (hi - lo) * (i + 0.5) / samples_along; };
  for (int z = 0; z < samples_along; ++z) {
    for (int y = 0; y < samples_along; ++y) {
      for (int x = 0; x < samples_along; ++x) {
        const Vec3 p{at(box.lo.x, box.hi.x, x), at(box.lo.y, box.hi.y, y), at(box.lo.z, box.hi.z, z)};
        found.insert(field.closest(p).triangle);
      }
    }
  }
  return found.size();
}

}  // namespace cdfr::bench
