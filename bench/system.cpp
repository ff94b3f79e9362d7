#include "system.h"

#include <algorithm>

namespace cdfr::bench {

void System::batch(std::span<const Vec3> points, std::span<double> out, unsigned) const {
  singles(points, out);
}

void System::fill(const SampleGrid& grid, std::span<double> out, unsigned threads) const {
  // A few planes at a time, so that the points are not another hundred megabytes to read.
  constexpr std::uint32_t some = 4;
  for (std::uint32_t first = 0; first < grid.size[2]; first += some) {
    const std::vector<Vec3> points = points_of(grid, first, std::min(some, grid.size[2] - first));
    batch(points, out.first(points.size()), threads);
    out = out.subspan(points.size());
  }
}

std::vector<SystemKind> peer_kinds() {
  return {
#ifdef CDFR_BENCH_EMBREE
      {"embree", build_embree},
#endif
#ifdef CDFR_BENCH_CGAL
      {"cgal", build_cgal},
#endif
#ifdef CDFR_BENCH_FCPW
      {"fcpw", build_fcpw},
#endif
  };
}

std::vector<SystemKind> system_kinds() {
  std::vector<SystemKind> kinds = peer_kinds();
  kinds.insert(kinds.begin(), {"cdfr", build_cdfr});
  return kinds;
}

}  // namespace cdfr::bench
